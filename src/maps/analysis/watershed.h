#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace somato {

/// The basins of heights on a graph whose vertex i is connected with `neighbours[i]`: the basin of
/// each vertex, numbered in the order of their first vertices. Connected vertices of equal height
/// form one plateau; a plateau between basins is divided by the number of steps from them, and in a
/// tie goes to the basin of the lowest vertex, which has the lowest number among equal ones. With
/// `count`, the shallowest basin, measured from its lowest vertex to its lowest pass, is filled
/// into the basin behind that pass until `count` are left, or no two are connected.
std::vector<std::size_t> basins(const std::vector<double>& heights,
                                const std::vector<std::vector<std::size_t>>& neighbours,
                                std::optional<std::size_t> count = {});

}  // namespace somato
