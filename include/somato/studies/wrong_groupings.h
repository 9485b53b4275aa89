#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace somato {

/// Classifications that are wrong on purpose: what a measure of areas says of them is what luck
/// alone would give.
///
/// The individuals are dealt to the classes anew, at random, each class keeping its number of
/// individuals; a dealing that puts the same individuals together as the right one is dealt again.
/// `classes[i]` and `individuals[i]` belong to sample i. Returns `count` classifications of the
/// samples, or none when every dealing is the right one (one class, or one individual a class).
std::vector<std::vector<std::size_t>> wrong_groupings(const std::vector<std::size_t>& classes,
                                                      const std::vector<std::size_t>& individuals,
                                                      std::size_t count, std::uint64_t seed);

}  // namespace somato
