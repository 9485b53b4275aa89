#include "views/http/http_access.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace somato::live {

std::vector<std::string> hosts_at(const std::string& address, std::uint16_t port) {
  std::vector<std::string> names{
      address.find(':') != std::string::npos ? fmt::format("[{}]", address) : address};
  if (address == "127.0.0.1" || address == "::1") names.emplace_back("localhost");
  std::vector<std::string> hosts;
  hosts.reserve(2 * names.size());
  for (const std::string& name : names) hosts.push_back(fmt::format("{}:{}", name, port));
  if (port == 80) hosts.insert(hosts.end(), names.begin(), names.end());
  return hosts;
}

HttpAccess::HttpAccess(std::vector<std::string> hosts, std::string token)
    : hosts_(std::move(hosts)), token_(std::move(token)) {}

HttpResult<void> HttpAccess::check_host(const HttpRequest& request) const {
  const auto host = request.header("host");
  if (host && std::find(hosts_.begin(), hosts_.end(), *host) != hosts_.end()) return {};
  return refuse(403, "The Host header does not match the address of this server. " + advice());
}

// A tunnel ends at this machine, where a server at another address is not reached by it.
std::string HttpAccess::advice() const {
  constexpr std::string_view kLocal = "localhost:";
  for (const std::string& host : hosts_) {
    if (!host.starts_with(kLocal)) continue;
    const std::string port = host.substr(kLocal.size());
    return fmt::format(
        "Through a tunnel, forward the port under the same number: ssh -L {0}:localhost:{0} HOST, "
        "and open http://{1}/ with the token that the program printed.",
        port, host);
  }
  return hosts_.empty() ? "" : fmt::format("Open http://{}/ instead.", hosts_.front());
}

HttpResult<void> HttpAccess::check_origin(const HttpRequest& request) const {
  const auto origin = request.header("origin");
  const auto is_own = [&](const std::string& host) { return *origin == "http://" + host; };
  if (origin && std::any_of(hosts_.begin(), hosts_.end(), is_own)) return {};
  return refuse(403, "Commands are accepted only from pages of this server.");
}

HttpResult<void> HttpAccess::check_token(const HttpRequest& request) const {
  const auto sent = request.header("x-somato-token");
  const auto token = sent ? sent : request.parameter("token");
  if (token && equal_in_constant_time(*token, token_)) return {};
  return refuse(403,
                "The token is missing or wrong; open the start address that the program printed.");
}

std::optional<std::string> new_token() {
  std::array<std::uint8_t, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const char other = b.empty() ? '\0' : b[i % b.size()];
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(other);
  }
  return difference == 0U;
}

}  // namespace somato::live
