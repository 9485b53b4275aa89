#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace somato::program {

/// "1 seed", "2 seeds".
inline std::string counted(std::uint64_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace somato::program
