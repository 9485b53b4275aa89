#include "somato/maps/neuron_graph.h"

#include <algorithm>
#include <limits>

#include "maps/grid/graph_cells.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::uint16_t kNoPath = std::numeric_limits<std::uint16_t>::max();

}  // namespace

NeuronGraph::NeuronGraph(std::size_t neurons, std::vector<Edge> edges)
    : edges_(std::move(edges)), neighbours_(neurons) {
  require(neurons <= kMostNeurons, "a graph has too many neurons");
  for (auto& [a, b] : edges_) {
    require(a != b && a < neurons && b < neurons, "an edge needs two different neurons");
    if (b < a) std::swap(a, b);
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
  }
  std::sort(edges_.begin(), edges_.end());
  require(std::adjacent_find(edges_.begin(), edges_.end()) == edges_.end(),
          "an edge of a graph is listed twice");
  for (std::vector<std::size_t>& around : neighbours_) std::sort(around.begin(), around.end());
  find_parts();
  cells_ = cells_of_graph(neighbours_, parts_);
  for (const Cell& cell : cells_) {
    extent_ = {std::max(extent_.row, cell.row + 1), std::max(extent_.column, cell.column + 1)};
  }
}

// A search in breadth from every neuron gives the shortest paths, and with them the parts.
void NeuronGraph::find_parts() {
  constexpr auto kNone = std::numeric_limits<std::size_t>::max();
  steps_.assign(size() * size(), kNoPath);
  parts_.assign(size(), kNone);
  std::size_t parts = 0;
  std::vector<std::size_t> reached;
  for (std::size_t start = 0; start < size(); ++start) {
    std::uint16_t* const steps = steps_.data() + start * size();
    const std::size_t part = parts_[start] == kNone ? parts++ : parts_[start];
    reached.assign(1, start);
    steps[start] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      parts_[reached[i]] = part;
      for (const std::size_t other : neighbours_[reached[i]]) {
        if (steps[other] != kNoPath) continue;
        steps[other] = static_cast<std::uint16_t>(steps[reached[i]] + 1);
        reached.push_back(other);
      }
    }
  }
}

std::optional<std::size_t> NeuronGraph::steps(std::size_t a, std::size_t b) const {
  const std::uint16_t found = steps_[a * size() + b];
  return found == kNoPath ? std::optional<std::size_t>() : found;
}

}  // namespace somato
