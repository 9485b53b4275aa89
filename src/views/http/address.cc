#include "views/http/address.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>

#include <array>

namespace somato {
namespace {

std::string text_of(int family, const void* address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  inet_ntop(family, address, text.data(), text.size());
  return text.data();
}

Address::Reach reach_of(const in_addr& address) {
  const std::uint32_t number = ntohl(address.s_addr);
  if (number == INADDR_ANY) return Address::Reach::kAll;
  return number >> 24U == 127U ? Address::Reach::kLoopback : Address::Reach::kInterface;
}

Address::Reach reach_of(const in6_addr& address) {
  if (IN6_IS_ADDR_UNSPECIFIED(&address)) return Address::Reach::kAll;
  return IN6_IS_ADDR_LOOPBACK(&address) ? Address::Reach::kLoopback : Address::Reach::kInterface;
}

}  // namespace

Result<Address> parse_address(const std::string& text) {
  in_addr v4{};
  if (inet_pton(AF_INET, text.c_str(), &v4) == 1) {
    return Address{text_of(AF_INET, &v4), reach_of(v4)};
  }
  in6_addr v6{};
  if (inet_pton(AF_INET6, text.c_str(), &v6) == 1) {
    return Address{text_of(AF_INET6, &v6), reach_of(v6)};
  }
  return fail(ErrorKind::kUsage, fmt::format("'{}' is not a numeric IP address", text), {},
              "use an address such as 127.0.0.1");
}

}  // namespace somato
