#include "terminal/service_manager.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace somato::program {
namespace {

constexpr std::size_t kLongestAddress = sizeof(sockaddr_un::sun_path) - 1;

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string() : std::string(text);
}

std::optional<std::int64_t> positive_number(const std::string& text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || number <= 0) return {};
  return number;
}

// WATCHDOG_PID names the process that is watched; a child inherits the variables.
Result<std::optional<std::chrono::microseconds>> read_patience() {
  using Patience = std::optional<std::chrono::microseconds>;
  const std::string text = environment("WATCHDOG_USEC");
  const std::string process = environment("WATCHDOG_PID");
  if (text.empty() || (!process.empty() && process != std::to_string(getpid()))) return Patience();
  if (const auto number = positive_number(text)) return Patience(*number);
  return fail(ErrorKind::kUsage, fmt::format("'{}' is not a number of microseconds", text),
              "WATCHDOG_USEC", "remove the variable; a service manager sets it");
}

sockaddr_un socket_address(const std::string& text) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(text.begin(), text.end(), address.sun_path);
  if (text.front() == '@') address.sun_path[0] = '\0';
  return address;
}

bool send(const std::string& to, const std::string& message) {
  const int handle = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (handle < 0) return false;
  const sockaddr_un address = socket_address(to);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + to.size());
  const auto sent = sendto(handle, message.data(), message.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
                           reinterpret_cast<const sockaddr*>(&address), size);
  const int reason = errno;
  close(handle);
  errno = reason;
  return std::cmp_equal(sent, message.size());
}

}  // namespace

Result<ServiceManager> ServiceManager::from_environment() {
  std::string address = environment("NOTIFY_SOCKET");
  if (address.empty()) return ServiceManager({}, {});
  const bool is_valid = (address.front() == '/' || address.front() == '@') && address.size() > 1 &&
                        address.size() <= kLongestAddress;
  if (!is_valid) {
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' is not the address of a local socket", address), "NOTIFY_SOCKET",
                "remove the variable; a service manager sets it");
  }
  SOMATO_TRY(const auto patience, read_patience());
  return ServiceManager(std::move(address), patience);
}

Result<void> ServiceManager::notify(const std::string& message) const {
  if (address_.empty() || send(address_, message)) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("the service manager cannot be notified: {}",
                          std::generic_category().message(errno)),
              address_, "run the program without NOTIFY_SOCKET, or start the manager again");
}

}  // namespace somato::program
