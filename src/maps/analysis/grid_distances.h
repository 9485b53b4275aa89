#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// The squared distances of all neurons from `neuron` on a grid. They are whole numbers on every
/// grid, so that rounding makes equal distances equal.
std::vector<double> squared_grid_distances(const Grid& grid, std::size_t neuron);

}  // namespace somato
