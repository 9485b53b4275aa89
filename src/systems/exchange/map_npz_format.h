#pragma once

#include <string>

namespace somato {

/// The text of the array `file_format` of a map in an NPZ archive, and the version behind it.
inline const std::string kMapNpzFormat = "somato map ";
inline constexpr int kMapNpzVersion = 1;

}  // namespace somato
