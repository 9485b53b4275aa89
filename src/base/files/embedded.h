#pragma once

#include <string_view>
#include <vector>

namespace somato::detail {

/// A text file of the tree that the library carries with it, under its path there.
struct EmbeddedFile {
  std::string_view path;
  std::string_view text;
};

/// All of them; written by the build.
const std::vector<EmbeddedFile>& embedded_files();

/// The text of the file of that path, such as "models/lucs_haptic_hand_2.xml", which must be there.
std::string_view embedded_text(std::string_view path);

}  // namespace somato::detail
