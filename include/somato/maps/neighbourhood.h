#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/maps/grid.h"

namespace somato {

/// How much the neurons around a winner learn with it.
enum class NeighbourhoodShape {
  kGaussian,  ///< exp(-d^2 / (2 radius^2)) at distance d.
  kBubble,    ///< 1 up to the radius, 0 beyond.
};

template <>
struct Choices<NeighbourhoodShape> {
  static const std::vector<std::pair<NeighbourhoodShape, std::string>>& all();
};

/// exp(-d^2 / (2 radius^2)) of a difference d in one direction; 0 below 2^-1000, and with radius 0
/// anywhere but at d = 0. A Gaussian is the product of this for rows and for columns.
double gaussian_factor(double difference, double radius);

/// The neighbourhood function on one grid, with its scratch memory: one object a thread.
class Neighbourhood {
 public:
  Neighbourhood(const Grid& grid, NeighbourhoodShape shape);

  /// Writes the neighbourhood function of every neuron around `winner` to `out`, which holds at
  /// least one value a neuron. `radius` >= 0; with radius 0 the winner alone has 1.
  void around(std::size_t winner, double radius, std::span<float> out);
  void around(std::size_t winner, double radius, std::span<double> out);

 private:
  template <typename Real>
  void write_around(std::size_t winner, double radius, std::span<Real> out);
  void prepare_factors(std::size_t winner, double radius);

  Grid grid_;
  NeighbourhoodShape shape_;
  // A Gaussian is a product of a factor of the row and a factor of the column; on a hexagonal grid
  // the latter depends on the row's parity.
  // Differences of places by their rows' and columns' numbers; the latter from -columns + 1 on, for
  // a row shifted to the left of, like, or to the right of the other.
  std::vector<double> vertical_;
  std::vector<double> horizontal_;  // 3 x (2 columns - 1)
  std::vector<double> row_factors_;
  std::vector<double> column_factors_;  // 2 x columns
};

}  // namespace somato
