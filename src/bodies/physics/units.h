#pragma once

#include <numbers>

namespace somato::detail {

inline constexpr double kMetres = 0.001;                      ///< In a mm.
inline constexpr double kRadians = std::numbers::pi / 180.0;  ///< In a deg.

}  // namespace somato::detail
