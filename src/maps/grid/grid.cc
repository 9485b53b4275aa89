#include "somato/maps/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostNeurons = std::size_t{1} << 24;
constexpr double kHexagonalRowHeight = 0x1.bb67ae8584caap-1;  // sqrt(3) / 2

// The shorter way round a ring of `length`.
double around(double difference, double length) {
  const double distance = std::fabs(difference);
  return std::min(distance, length - distance);
}

double difference(std::size_t a, std::size_t b) {
  return static_cast<double>(a) - static_cast<double>(b);
}

}  // namespace

const std::vector<std::pair<Lattice, std::string>>& Choices<Lattice>::all() {
  static const std::vector<std::pair<Lattice, std::string>> choices{
      {Lattice::kRectangular, "rectangular"}, {Lattice::kHexagonal, "hexagonal"}};
  return choices;
}

const std::vector<std::pair<Topology, std::string>>& Choices<Topology>::all() {
  static const std::vector<std::pair<Topology, std::string>> choices{{Topology::kPlane, "plane"},
                                                                     {Topology::kTorus, "torus"}};
  return choices;
}

Grid::Grid(std::size_t rows, std::size_t columns, Lattice lattice, Topology topology)
    : rows_(rows), columns_(columns), lattice_(lattice), topology_(topology) {
  const Result<void> valid = validate(rows, columns, lattice, topology);
  if (!valid) throw InvalidArgument(to_string(valid.error()));
}

Grid::Grid(std::shared_ptr<const NeuronGraph> graph)
    : rows_(1), columns_(graph->size()), graph_(std::move(graph)) {
  require(columns_ > 0, "a map needs at least one neuron");
}

bool Grid::operator==(const Grid& other) const {
  const bool has_graph = graph_ != nullptr;
  if (has_graph != (other.graph_ != nullptr)) return false;
  if (has_graph) return *graph_ == *other.graph_;
  return rows_ == other.rows_ && columns_ == other.columns_ && lattice_ == other.lattice_ &&
         topology_ == other.topology_;
}

Result<void> Grid::validate(std::size_t rows, std::size_t columns, Lattice lattice,
                            Topology topology) {
  if (rows == 0 || columns == 0) {
    return fail(ErrorKind::kUsage, "a map needs at least one row and one column", {},
                "set 'rows' and 'columns' to 1 or more");
  }
  if (rows > kMostNeurons / columns) {
    return fail(
        ErrorKind::kUsage,
        fmt::format("a map of {} x {} has more than {} neurons", rows, columns, kMostNeurons), {},
        "choose fewer rows or columns");
  }
  if (lattice == Lattice::kHexagonal && topology == Topology::kTorus && rows % 2 == 1) {
    return fail(
        ErrorKind::kUsage,
        fmt::format("a hexagonal torus needs an even number of rows, not {}", rows), {},
        rows == 1 ? "set 'rows' to 2" : fmt::format("set 'rows' to {} or {}", rows - 1, rows + 1));
  }
  return {};
}

Position Grid::position(std::size_t neuron) const {
  if (graph_) {
    const NeuronGraph::Cell& cell = graph_->cells()[neuron];
    return {static_cast<double>(cell.column), static_cast<double>(cell.row)};
  }
  const auto row = static_cast<double>(row_of(neuron));
  const auto column = static_cast<double>(column_of(neuron));
  if (lattice_ == Lattice::kRectangular) return {column, row};
  return {column + 0.5 * static_cast<double>(row_of(neuron) % 2), row * kHexagonalRowHeight};
}

double Grid::horizontal_difference(std::size_t column, std::size_t parity, std::size_t other_column,
                                   std::size_t other_parity) const {
  const double shift = lattice_ == Lattice::kHexagonal ? 0.5 * difference(parity, other_parity) : 0;
  const double straight = difference(column, other_column) + shift;
  return topology_ == Topology::kPlane ? straight : around(straight, static_cast<double>(columns_));
}

double Grid::vertical_difference(std::size_t row, std::size_t other_row) const {
  const double height = lattice_ == Lattice::kHexagonal ? kHexagonalRowHeight : 1.0;
  const double straight = difference(row, other_row);
  const double rows =
      topology_ == Topology::kPlane ? straight : around(straight, static_cast<double>(rows_));
  return rows * height;
}

double Grid::squared_distance(std::size_t a, std::size_t b) const {
  if (graph_) {
    const auto steps = graph_->steps(a, b);
    if (!steps) return std::numeric_limits<double>::infinity();
    return static_cast<double>(*steps) * static_cast<double>(*steps);
  }
  const double x = horizontal_difference(column_of(a), row_of(a) % 2, column_of(b), row_of(b) % 2);
  const double y = vertical_difference(row_of(a), row_of(b));
  return x * x + y * y;
}

bool Grid::adjacent(std::size_t a, std::size_t b) const {
  constexpr double kBetweenOneAndTwo = 1.5;  // the next neurons are at sqrt(2) or sqrt(3)
  return a != b && squared_distance(a, b) < kBetweenOneAndTwo;
}

std::vector<std::size_t> Grid::neighbours(std::size_t neuron) const {
  if (graph_) return graph_->neighbours(neuron);
  std::vector<std::size_t> found;
  const std::size_t row = row_of(neuron);
  const std::size_t column = column_of(neuron);
  for (const std::size_t r : {row + rows_ - 1, row + rows_, row + rows_ + 1}) {
    for (const std::size_t c : {column + columns_ - 1, column + columns_, column + columns_ + 1}) {
      const std::size_t other = r % rows_ * columns_ + c % columns_;
      if (adjacent(neuron, other)) found.push_back(other);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace somato
