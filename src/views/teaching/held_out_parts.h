#pragma once

#include <cstddef>
#include <vector>

namespace somato::live {

/// A division of explorations for a threshold: those of one part are held out of a training.
struct HeldOutPart {
  std::vector<std::size_t> training;
  std::vector<std::size_t> held_out;
};

/// Deals the explorations of each class to `parts` parts in turn; `class_of` has the class of each.
/// Every exploration is held out once. Empty if a class has a single exploration, which a training
/// without it would not know, or if there are too few explorations for `false_alarm_rate`.
std::vector<HeldOutPart> held_out_parts(const std::vector<std::size_t>& class_of, std::size_t parts,
                                        double false_alarm_rate);

}  // namespace somato::live
