#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/drawing/map_picture.h"
#include "somato/maps/grid.h"

namespace somato {

/// The cells of an expanded U-matrix of a grid with rows and columns: a grid with half the spacing,
/// of the same lattice and without joined edges. Some of its cells have no value.
class ExpandedGrid {
 public:
  explicit ExpandedGrid(const Grid& grid);

  const Grid& fine() const { return fine_; }

  /// The fine cell of a neuron.
  std::size_t cell_of(std::size_t neuron) const;

  /// The fine cell between two neurons that are at most a diagonal apart; between neurons on
  /// opposite sides of a torus, it is beyond the last row or column. Throws InvalidArgument for
  /// others.
  std::size_t cell_between(std::size_t first, std::size_t second) const;

 private:
  std::size_t place(const Grid& grid, std::size_t neuron) const;

  Grid grid_;
  Grid fine_;
};

/// The values of the fine cells, and what each of them shows.
struct ExpandedValues {
  std::vector<std::optional<double>> values;
  std::vector<std::string> descriptions;
};

/// Neurons have their values; other cells have the mean of the values at their place.
ExpandedValues expanded_values(const ExpandedGrid& expanded, const EdgePanel& panel);

}  // namespace somato
