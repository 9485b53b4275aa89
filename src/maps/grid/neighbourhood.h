#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/maps/grid.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// exp(-d^2 / (2 radius^2)) of a difference d in one direction; 0 below 2^-1000, and with radius 0
/// everywhere except at d = 0. A Gaussian is the product of this for rows and for columns.
double gaussian_factor(double difference, double radius);

/// The neighbourhood function on a grid, with scratch memory: use one object per thread.
class Neighbourhood {
 public:
  Neighbourhood(const Grid& grid, NeighbourhoodShape shape);

  /// Writes the neighbourhood function of every neuron around `winner` to `out`, which has at least
  /// one value per neuron. `radius` >= 0; with radius 0 only the winner has 1.
  void around(std::size_t winner, double radius, std::span<float> out);
  void around(std::size_t winner, double radius, std::span<double> out);

 private:
  template <typename Real>
  void write_around(std::size_t winner, double radius, std::span<Real> out);
  template <typename Real>
  void write_by_distance(std::size_t winner, double radius, std::span<Real> out) const;
  void prepare_factors(std::size_t winner, double radius);

  Grid grid_;
  NeighbourhoodShape shape_;
  // A Gaussian is a product of a factor of the row and a factor of the column; on a hexagonal grid
  // the latter depends on the row's parity. Differences of positions, by row and column numbers;
  // the latter from -columns + 1, for a row shifted to the left, equally, or to the right relative
  // to the other.
  std::vector<double> vertical_;
  std::vector<double> horizontal_;  // 3 x (2 columns - 1)
  std::vector<double> row_factors_;
  std::vector<double> column_factors_;  // 2 x columns
};

}  // namespace somato
