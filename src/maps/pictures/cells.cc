#include "maps/pictures/cells.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

namespace somato {
namespace {

constexpr double kSquareRootOf3 = 0x1.bb67ae8584caap+0;

// Corners around the centre of a cell, in units.
constexpr std::array<Point, 4> kSquare{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
constexpr std::array<Point, 6> kHexagon{{{0, -2}, {1, -1}, {1, 1}, {0, 2}, {-1, 1}, {-1, -1}}};

// An edge by its ends, the same from both of its sides.
using Edge = std::pair<std::pair<double, double>, std::pair<double, double>>;

Edge edge_between(Point a, Point b) {
  return std::minmax(std::pair(a.x, a.y), std::pair(b.x, b.y));
}

struct Sides {
  std::size_t area = 0;
  bool has_other = false;
  bool differs = false;
};

void append(std::vector<Point>& ends, const Edge& edge) {
  ends.push_back({edge.first.first, edge.first.second});
  ends.push_back({edge.second.first, edge.second.second});
}

}  // namespace

Cells::Cells(Grid grid, double pixels) : grid_(std::move(grid)), pixels_(pixels) {}

Point Cells::unit() const {
  const double half = pixels_ / 2;
  return {half, grid_.lattice() == Lattice::kRectangular ? half : half / kSquareRootOf3};
}

double Cells::width() const {
  if (grid_.graph()) return pixels_ * real(grid_.graph()->extent().column);
  const bool is_shifted = grid_.lattice() == Lattice::kHexagonal && grid_.rows() > 1;
  return pixels_ * (real(grid_.columns()) + (is_shifted ? 0.5 : 0.0));
}

double Cells::height() const {
  if (grid_.graph()) return pixels_ * real(grid_.graph()->extent().row);
  if (grid_.lattice() == Lattice::kRectangular) return pixels_ * real(grid_.rows());
  return unit().y * (3 * real(grid_.rows()) + 1);
}

double Cells::inner_side() const {
  // A corner (h, h) of the square lies on the hexagon's side h / sqrt(3) + h = width / sqrt(3).
  return grid_.lattice() == Lattice::kRectangular ? pixels_ : pixels_ * 2 / (1 + kSquareRootOf3);
}

Point Cells::text_area() const {
  // The upright sides of a hexagon are as long as its radius, two units.
  return {pixels_, 2 * unit().y};
}

Point Cells::centre_in_units(std::size_t neuron) const {
  if (const NeuronGraph* graph = grid_.graph()) {
    const NeuronGraph::Cell& cell = graph->cells()[neuron];
    return {real(2 * cell.column + 1), real(2 * cell.row + 1)};
  }
  const std::size_t row = grid_.row_of(neuron);
  const std::size_t column = grid_.column_of(neuron);
  if (grid_.lattice() == Lattice::kRectangular) return {real(2 * column + 1), real(2 * row + 1)};
  return {real(2 * column + row % 2 + 1), real(3 * row + 2)};
}

Point Cells::centre(std::size_t neuron) const {
  const Point centre = centre_in_units(neuron);
  return {centre.x * unit().x, centre.y * unit().y};
}

std::vector<Point> Cells::corners(std::size_t neuron) const {
  const Point centre = centre_in_units(neuron);
  const bool is_square = grid_.lattice() == Lattice::kRectangular;
  std::vector<Point> corners;
  for (const Point& corner : is_square ? std::span<const Point>(kSquare) : kHexagon) {
    corners.push_back({corner.x + centre.x, corner.y + centre.y});
  }
  return corners;
}

std::vector<Point> Cells::connections() const {
  std::vector<Point> ends;
  if (!grid_.graph()) return ends;
  ends.reserve(2 * grid_.graph()->edges().size());
  for (const auto& [a, b] : grid_.graph()->edges()) {
    ends.push_back(centre_in_units(a));
    ends.push_back(centre_in_units(b));
  }
  return ends;
}

Cells::Borders Cells::borders(const std::vector<std::size_t>& area_of_neuron) const {
  std::map<Edge, Sides> edges;
  for (std::size_t neuron = 0; neuron < grid_.size(); ++neuron) {
    const std::vector<Point> around = corners(neuron);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Edge edge = edge_between(around[i], around[(i + 1) % around.size()]);
      const auto [found, is_new] = edges.try_emplace(edge, Sides{area_of_neuron[neuron]});
      found->second.has_other = !is_new;
      found->second.differs = found->second.area != area_of_neuron[neuron];
    }
  }
  Borders borders;
  for (const auto& [edge, sides] : edges) {
    append(!sides.has_other ? borders.around_map
           : sides.differs  ? borders.between_areas
                            : borders.within_areas,
           edge);
  }
  return borders;
}

}  // namespace somato
