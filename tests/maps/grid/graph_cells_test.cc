#include "maps/grid/graph_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "somato/core/random.h"

namespace somato {
namespace {

using Cell = NeuronGraph::Cell;

std::size_t apart(const Cell& a, const Cell& b) {
  const auto between = [](std::size_t one, std::size_t other) {
    return std::max(one, other) - std::min(one, other);
  };
  return std::max(between(a.row, b.row), between(a.column, b.column));
}

TEST(GraphCells, PutConnectedNeuronsBesideEachOther) {
  const NeuronGraph triangle(3, {{0, 1}, {1, 2}, {0, 2}});
  for (const auto& [a, b] : triangle.edges()) {
    EXPECT_EQ(apart(triangle.cells()[a], triangle.cells()[b]), 1U);
  }
}

// The first neuron of a star is its middle; its eight neighbours are around it.
TEST(GraphCells, PutTheMiddleOfAStarInTheMiddle) {
  std::vector<NeuronGraph::Edge> edges;
  for (std::size_t other = 0; other < 9; ++other) {
    if (other != 4)
      edges.emplace_back(std::min<std::size_t>(4, other), std::max<std::size_t>(4, other));
  }
  const NeuronGraph star(9, edges);
  EXPECT_EQ(star.cells()[4], (Cell{1, 1}));
  EXPECT_EQ(star.extent(), (Cell{3, 3}));
}

TEST(GraphCells, SeparateThePartsByAColumn) {
  const NeuronGraph pairs(4, {{0, 1}, {2, 3}});
  const std::size_t end = std::max(pairs.cells()[0].column, pairs.cells()[1].column);
  const std::size_t begin = std::min(pairs.cells()[2].column, pairs.cells()[3].column);
  EXPECT_EQ(begin, end + 2);
}

TEST(GraphCells, AreDifferentForAllNeurons) {
  Random random(7);
  std::vector<NeuronGraph::Edge> edges;
  for (std::size_t a = 0; a < 60; ++a) {
    for (std::size_t b = a + 1; b < 60; ++b) {
      if (random.below(20) == 0) edges.emplace_back(a, b);
    }
  }
  const NeuronGraph graph(60, edges);
  std::set<std::pair<std::size_t, std::size_t>> cells;
  for (const Cell& cell : graph.cells()) {
    cells.emplace(cell.row, cell.column);
    EXPECT_LT(cell.row, graph.extent().row);
    EXPECT_LT(cell.column, graph.extent().column);
  }
  EXPECT_EQ(cells.size(), 60U);
}

}  // namespace
}  // namespace somato
