#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// Something with a number, such as an object with its girth, in a group, such as its shape.
struct SizedThing {
  double number = 0.0;
  std::size_t group = 0;
};

/// For each of `queries` the most similar known things, ascending: those of the same group with the
/// nearest number, both in a tie (numbers that are equally near up to rounding); none without one
/// of its group. This is P11's (III-B) most similar object of the training set: the paper does not
/// define it, and gives only shape and size of its objects. Throws InvalidArgument for a number
/// that is not finite.
std::vector<std::vector<std::size_t>> most_similar(const std::vector<SizedThing>& known,
                                                   const std::vector<SizedThing>& queries);

/// Whether each thing is one of the large ones of its group: not below the median of the group, the
/// upper one of two; of five, two are small and three large. Equal numbers are never separated, so
/// if the lower half equals the median, all are large. P11 (III-B, Fig. 6b) distinguishes small and
/// large cylinders and blocks; which are which, and how many, is not given in the paper. Throws
/// InvalidArgument for a number that is not finite.
std::vector<bool> is_large(const std::vector<SizedThing>& things);

}  // namespace somato
