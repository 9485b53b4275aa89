#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "somato/drawing/svg.h"
#include "somato/maps/grid.h"

namespace somato {

/// A number of things as a factor of a length.
inline double real(std::size_t number) {
  return static_cast<double>(number);
}

/// Where the cells of a map lie: squares, or hexagons that stand on a corner, without gaps.
///
/// Corners are whole numbers of units, unit().x pixels wide and unit().y high: half a cell, or on
/// a hexagonal grid half a cell and a quarter of its height. So the corner that cells share is
/// exactly the same point.
class Cells {
 public:
  /// Cells `pixels` wide.
  Cells(const Grid& grid, double pixels);

  const Grid& grid() const { return grid_; }
  double pixels() const { return pixels_; }
  Point unit() const;

  /// The size of the map, in pixels.
  double width() const;
  double height() const;

  /// The side of the greatest upright square within a cell, in pixels.
  double inner_side() const;

  /// In pixels.
  Point centre(std::size_t neuron) const;

  /// In units, clockwise.
  std::vector<Point> corners(std::size_t neuron) const;

  /// The edges between cells of one area, of different areas, and around the map: pairs of ends,
  /// in units. Areas that meet only across the edge of a torus have no border there.
  struct Borders {
    std::vector<Point> within_areas;
    std::vector<Point> between_areas;
    std::vector<Point> around_map;
  };
  Borders borders(const std::vector<std::size_t>& area_of_neuron) const;

 private:
  Point centre_in_units(std::size_t neuron) const;

  Grid grid_;
  double pixels_;
};

}  // namespace somato
