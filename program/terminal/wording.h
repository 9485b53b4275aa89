#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace somato::program {

/// "1 seed", "2 seeds".
inline std::string counted(std::uint64_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Names of files, columns and labels are untrusted input: a terminal must not interpret them as
/// commands.
inline std::string printable(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\x{:02X}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace somato::program
