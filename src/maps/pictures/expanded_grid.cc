#include "maps/pictures/expanded_grid.h"

#include <algorithm>

#include "maps/pictures/panel_frame.h"
#include "maps/svg/colour_bar.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// The cells of a side with `neurons` neurons: a joined edge has a cell as well, unless two neurons
// are neighbours on both sides.
std::size_t fine_side(std::size_t neurons, Topology topology) {
  return 2 * neurons - (topology == Topology::kTorus && neurons > 2 ? 0 : 1);
}

bool is_hexagonal(const Grid& grid) {
  return grid.lattice() == Lattice::kHexagonal;
}

Grid fine_grid(const Grid& grid) {
  const std::size_t rows = fine_side(grid.rows(), grid.topology());
  const std::size_t columns = is_hexagonal(grid) && grid.rows() > 1
                                  ? 2 * grid.columns()
                                  : fine_side(grid.columns(), grid.topology());
  return {rows, columns, grid.lattice(), Topology::kPlane};
}

// Twice the middle of two places, each of which is 2 from the next one, on a circle of 2 * count.
std::size_t twice_the_middle(std::size_t a, std::size_t b, std::size_t count) {
  const bool is_across = std::max(a, b) - std::min(a, b) > 2;
  return a + b + (is_across ? 2 * count : 0);
}

}  // namespace

ExpandedGrid::ExpandedGrid(const Grid& grid) : grid_(grid), fine_(fine_grid(grid)) {}

// In half columns from the left.
std::size_t ExpandedGrid::place(const Grid& grid, std::size_t neuron) const {
  const std::size_t shift = is_hexagonal(grid) ? grid.row_of(neuron) % 2 : 0;
  return 2 * grid.column_of(neuron) + shift;
}

std::size_t ExpandedGrid::cell_of(std::size_t neuron) const {
  return 2 * grid_.row_of(neuron) * fine_.columns() + place(grid_, neuron);
}

std::size_t ExpandedGrid::cell_between(std::size_t first, std::size_t second) const {
  require(first < grid_.size() && second < grid_.size() && first != second,
          "an edge connects two neurons of the map");
  const double furthest = is_hexagonal(grid_) ? 1.0 : 2.0;
  require(grid_.squared_distance(first, second) < furthest + 0.1,
          "an edge connects neurons that are beside each other");
  const std::size_t row =
      twice_the_middle(2 * grid_.row_of(first), 2 * grid_.row_of(second), grid_.rows()) / 2;
  const std::size_t column =
      twice_the_middle(place(grid_, first), place(grid_, second), grid_.columns()) / 2;
  return row * fine_.columns() + column % std::max<std::size_t>(2 * grid_.columns(), 1);
}

ExpandedValues expanded_values(const ExpandedGrid& expanded, const EdgePanel& panel) {
  const std::size_t cells = expanded.fine().size();
  std::vector<double> sums(cells, 0.0);
  std::vector<std::size_t> counts(cells, 0);
  ExpandedValues all{std::vector<std::optional<double>>(cells), std::vector<std::string>(cells)};
  for (const auto& [first, second, value] : panel.edges) {
    const std::size_t cell = expanded.cell_between(first, second);
    sums[cell] += value;
    ++counts[cell];
    std::string& text = all.descriptions[cell];
    text += (text.empty() ? "" : ", ") + place_of(panel.grid, first) + " to " +
            place_of(panel.grid, second) + ": " + readable_number(value);
  }
  for (std::size_t i = 0; i < cells; ++i) {
    if (counts[i] > 0) all.values[i] = sums[i] / static_cast<double>(counts[i]);
  }
  for (std::size_t i = 0; i < panel.values.size(); ++i) {
    const std::size_t cell = expanded.cell_of(i);
    all.values[cell] = panel.values[i];
    all.descriptions[cell] = place_of(panel.grid, i) + ": " + readable_number(panel.values[i]);
  }
  return all;
}

}  // namespace somato
