#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "maps/svg/svg.h"
#include "somato/maps/grid.h"

namespace somato {

/// A number of things as a factor of a length.
inline double real(std::size_t number) {
  return static_cast<double>(number);
}

/// The distance of two points.
inline double distance(Point a, Point b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// The positions of the cells of a map: squares, or hexagons with a corner at the top, without
/// gaps. The neurons of a graph are squares with gaps.
///
/// Corners are integer multiples of units, unit().x pixels wide and unit().y high: half a cell, or
/// on a hexagonal grid half a cell and a quarter of its height. Cells therefore share exactly the
/// same corner points.
class Cells {
 public:
  /// Cells `pixels` wide.
  Cells(Grid grid, double pixels);

  const Grid& grid() const { return grid_; }
  double pixels() const { return pixels_; }
  Point unit() const;

  /// The size of the map, in pixels.
  double width() const;
  double height() const;

  /// The side of the greatest upright square within a cell, in pixels.
  double inner_side() const;

  /// The size of the greatest upright rectangle within a cell that is as wide as the cell.
  Point text_area() const;

  /// In pixels.
  Point centre(std::size_t neuron) const;

  /// In units, clockwise.
  std::vector<Point> corners(std::size_t neuron) const;

  /// The edges of a graph, from centre to centre: pairs of ends, in units. Empty for a grid.
  std::vector<Point> connections() const;

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
