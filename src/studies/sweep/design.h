#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace somato {

/// A Latin hypercube: `points` points of `dimensions` numbers in [0, 1). In each dimension the
/// points are in random order in the `points` equal parts of the range, one in each part, at a
/// random position. Source: McKay, Beckman, Conover, Technometrics 21 (1979). The result depends
/// only on the seed; the first dimensions are the same for any number of dimensions. Throws
/// InvalidArgument for more than 2^20 points.
std::vector<std::vector<double>> latin_hypercube(std::size_t points, std::size_t dimensions,
                                                 std::uint64_t seed);

/// All combinations of levels, where dimension d has `levels[d]` of them, numbered from 0; the last
/// dimension changes fastest.
std::vector<std::vector<std::size_t>> full_factorial(const std::vector<std::size_t>& levels);

/// No level of any dimension, then each level of each dimension with no level of the others.
std::vector<std::vector<std::optional<std::size_t>>> one_at_a_time(
    const std::vector<std::size_t>& levels);

}  // namespace somato
