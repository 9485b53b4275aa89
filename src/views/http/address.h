#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato {

/// An address of this machine that a server can be reached at.
struct Address {
  /// The clients that can reach it: only this machine; machines that reach one of its interfaces;
  /// or all interfaces.
  enum class Reach { kLoopback, kInterface, kAll };

  std::string text;  ///< As browsers write it: "::1", also where "0:0:0:0:0:0:0:1" was given.
  Reach reach = Reach::kInterface;
};

/// The address of IPv4 or IPv6 that `text` gives in digits. Errors (kUsage): it is none.
Result<Address> parse_address(const std::string& text);

}  // namespace somato
