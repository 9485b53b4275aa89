#include "maps/analysis/grid_distances.h"

#include <cmath>

namespace somato {

std::vector<double> squared_grid_distances(const Grid& grid, std::size_t neuron) {
  std::vector<double> squares(grid.size());
  for (std::size_t other = 0; other < grid.size(); ++other) {
    squares[other] = std::round(grid.squared_distance(neuron, other));
  }
  return squares;
}

}  // namespace somato
