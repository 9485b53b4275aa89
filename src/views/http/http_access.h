#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "views/http/http_request.h"

namespace somato::live {

/// The hosts that a server at that address answers to, as browsers write them: they leave out the
/// port that they would take anyway. `address` is as parse_address() writes it; localhost is
/// another name of those two that it may stand for.
std::vector<std::string> hosts_at(const std::string& address, std::uint16_t port);

/// Restricts access to clients with the start address. Pages of other origins can send requests to
/// this machine as well, and can make their own name resolve to it.
class HttpAccess {
 public:
  /// `hosts` are those that the server answers to, with their ports, exactly as a Host header has
  /// them; pages that they serve are our own.
  HttpAccess(std::vector<std::string> hosts, std::string token);

  /// Refuses (403) another host, or none, and says how a tunnel reaches the server; and with POST
  /// another origin, or none.
  HttpResult<void> check_host(const HttpRequest& request) const;
  HttpResult<void> check_origin(const HttpRequest& request) const;

  /// Refuses (403) a request without the token, as the parameter `token` or the header
  /// X-Somato-Token.
  HttpResult<void> check_token(const HttpRequest& request) const;

 private:
  std::string advice() const;

  std::vector<std::string> hosts_;
  std::string token_;
};

/// A secret of 128 random bits in 32 hexadecimal digits, from the system's source of randomness;
/// nothing where that fails.
std::optional<std::string> new_token();

/// Whether the two are equal, in a time that does not depend on where they differ.
bool equal_in_constant_time(std::string_view a, std::string_view b);

}  // namespace somato::live
