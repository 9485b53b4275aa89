#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace somato {

/// The connections of a map that is not a grid: an undirected graph of neurons. It never changes.
class NeuronGraph {
 public:
  /// Two connected neurons, the lower number first.
  using Edge = std::pair<std::size_t, std::size_t>;

  /// The maximum number of neurons; the distances of all pairs are stored.
  static constexpr std::size_t kMostNeurons = 4096;

  /// A graph of `neurons` neurons with these edges, in any order. Throws InvalidArgument for more
  /// than kMostNeurons neurons, for an edge that starts and ends at the same neuron or at one that
  /// does not exist, and for an edge that is listed twice.
  NeuronGraph(std::size_t neurons, std::vector<Edge> edges);

  std::size_t size() const { return neighbours_.size(); }

  /// Ascending, without repeats.
  const std::vector<Edge>& edges() const { return edges_; }

  /// The neurons connected with `neuron`, ascending.
  const std::vector<std::size_t>& neighbours(std::size_t neuron) const {
    return neighbours_[neuron];
  }

  /// The number of edges on the shortest path between two neurons; empty if there is no path.
  std::optional<std::size_t> steps(std::size_t a, std::size_t b) const;

  /// The connected part that each neuron belongs to, numbered from 0 in the order of their first
  /// neurons.
  const std::vector<std::size_t>& parts() const { return parts_; }

  /// A cell of a drawing.
  struct Cell {
    std::size_t row = 0;
    std::size_t column = 0;

    bool operator==(const Cell&) const = default;
  };

  /// A cell for each neuron, no two in the same one: each neuron is in a free cell beside the taken
  /// ones, the one nearest to the mean of its neighbours that were placed before. The first neuron
  /// is one with the most neighbours. Connected parts are beside each other, separated by an empty
  /// column.
  const std::vector<Cell>& cells() const { return cells_; }

  /// The number of rows and columns that the cells take.
  Cell extent() const { return extent_; }

  bool operator==(const NeuronGraph& other) const {
    return size() == other.size() && edges_ == other.edges_;
  }

 private:
  void find_parts();

  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<std::size_t> parts_;
  std::vector<std::uint16_t> steps_;  // of each pair, row by row
  std::vector<Cell> cells_;
  Cell extent_;
};

}  // namespace somato
