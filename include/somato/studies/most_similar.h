#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// Something with a number, such as an object with its girth, in a group, such as its shape.
struct SizedThing {
  double number = 0.0;
  std::size_t group = 0;
};

/// For each of `asked` the known things most similar to it, ascending: of the same group those with
/// the nearest number, both in a tie (numbers as near but for rounding); none without one of its
/// group. What P11 (III-B) calls the most similar object of the training set: the paper leaves open
/// how it judged that, and shape and size are all it tells of its objects. Throws InvalidArgument
/// for a number that is not finite.
std::vector<std::vector<std::size_t>> most_similar(const std::vector<SizedThing>& known,
                                                   const std::vector<SizedThing>& asked);

/// Whether each thing is one of the large ones of its group: not below the median thing of the
/// group, the upper one of two; of five, two are small and three large. Equal numbers are never
/// parted, so where the lower half equals the median all are large. P11 (III-B, Fig. 6b) tells
/// small from large cylinders and blocks; which are which, and how many, is not given in the paper.
/// Throws InvalidArgument for a number that is not finite.
std::vector<bool> is_large(const std::vector<SizedThing>& things);

}  // namespace somato
