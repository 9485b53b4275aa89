#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace somato {

/// Intentionally wrong classifications: the values of measures of areas for them are the values by
/// chance.
///
/// The individuals are reassigned to the classes at random, with the number of individuals of each
/// class unchanged; an assignment with the same grouping as the true one is drawn again.
/// `classes[i]` and `individuals[i]` belong to sample i. Returns `count` classifications of the
/// samples, or none if every assignment is the true one (one class, or one individual per class).
std::vector<std::vector<std::size_t>> wrong_groupings(const std::vector<std::size_t>& classes,
                                                      const std::vector<std::size_t>& individuals,
                                                      std::size_t count, std::uint64_t seed);

}  // namespace somato
