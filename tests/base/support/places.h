#pragma once

#include <string>
#include <string_view>

namespace somato {

/// The path of a file or folder of the source tree, such as "examples/synthetic_grasps".
std::string source_path(std::string_view name);

/// The path of a file or folder of the build.
std::string build_path(std::string_view name);

/// The program `somato` of the build.
inline std::string built_program() {
  return build_path("somato");
}

}  // namespace somato
