#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// Something with a number, such as an object with its girth, in a group, such as its shape.
struct SizedThing {
  double number = 0.0;
  std::size_t group = 0;
};

/// For each of `asked` the known things most similar to it: of the same group those with the nearest
/// number, both in a tie; none without one of its group.
std::vector<std::vector<std::size_t>> most_similar(const std::vector<SizedThing>& known,
                                                   const std::vector<SizedThing>& asked);

/// Whether each thing is one of the large ones of its group: not below the median thing of the
/// group, the upper one of two. P11 tells small from large cylinders and blocks; which are which is
/// not given in the paper.
std::vector<bool> is_large(const std::vector<SizedThing>& things);

}  // namespace somato
