#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/maps/neuron_graph.h"

namespace somato {

/// Layout of the neurons of a map.
enum class Lattice {
  kRectangular,  ///< Rows and columns at right angles, 1 apart.
  kHexagonal,    ///< Odd rows shifted right by 1/2, rows sqrt(3)/2 apart: six neighbours at
                 ///< distance 1.
};

/// Behaviour at the edges of a map.
enum class Topology {
  kPlane,  ///< The map has borders.
  kTorus,  ///< Opposite edges are joined.
};

template <>
struct Choices<Lattice> {
  static const std::vector<std::pair<Lattice, std::string>>& all();
};
template <>
struct Choices<Topology> {
  static const std::vector<std::pair<Topology, std::string>>& all();
};

/// A position on the map, in units of the distance between neighbours in a row; y increases
/// downwards.
struct Position {
  double x = 0.0;
  double y = 0.0;
};

/// The grid of a map's neurons, numbered row by row; or the graph of a map that grows, whose
/// neurons are numbered in a single row.
class Grid {
 public:
  Grid() = default;

  /// The neurons of a graph: rows() is 1. Throws InvalidArgument if it has no neurons.
  explicit Grid(std::shared_ptr<const NeuronGraph> graph);

  /// Throws InvalidArgument for a grid that validate() refuses.
  Grid(std::size_t rows, std::size_t columns, Lattice lattice, Topology topology);

  /// Fails (kUsage) for a side of 0, more than 2^24 neurons, or a hexagonal torus with an odd
  /// number of rows, whose first and last row would have the same shift and could not be
  /// neighbours.
  static Result<void> validate(std::size_t rows, std::size_t columns, Lattice lattice,
                               Topology topology);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t size() const { return rows_ * columns_; }
  Lattice lattice() const { return lattice_; }
  Topology topology() const { return topology_; }

  /// The graph, or nullptr for rows and columns.
  const NeuronGraph* graph() const { return graph_.get(); }

  std::size_t row_of(std::size_t neuron) const { return neuron / columns_; }
  std::size_t column_of(std::size_t neuron) const { return neuron % columns_; }

  /// On a graph, the neuron's cell (NeuronGraph::cells()).
  Position position(std::size_t neuron) const;

  /// The squared distance of two neurons; on a torus along the shortest path. On a graph, the
  /// squared number of edges between them, infinite if there is no path.
  double squared_distance(std::size_t a, std::size_t b) const;

  /// The difference in x of a neuron in column `column`, in a row of parity `parity` (0 even, 1
  /// odd), from another such neuron: squared_distance is the sum of the squares of this and of
  /// vertical_difference. Neither is defined on a graph.
  double horizontal_difference(std::size_t column, std::size_t parity, std::size_t other_column,
                               std::size_t other_parity) const;
  double vertical_difference(std::size_t row, std::size_t other_row) const;

  /// The neurons that share an edge with `neuron`, ascending: those at distance 1, up to four on a
  /// rectangular and six on a hexagonal grid, fewer at the edges of a plane; on a graph those that
  /// are connected with it.
  std::vector<std::size_t> neighbours(std::size_t neuron) const;

  /// Whether two neurons share an edge.
  bool adjacent(std::size_t a, std::size_t b) const;

  bool operator==(const Grid& other) const;

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  Lattice lattice_ = Lattice::kRectangular;
  Topology topology_ = Topology::kPlane;
  std::shared_ptr<const NeuronGraph> graph_;
};

}  // namespace somato
