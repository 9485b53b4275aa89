#include "somato/maps/neuron_graph.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Edges = std::vector<NeuronGraph::Edge>;

// 0 - 2 - 3 - 5, 2 - 5, and apart from them 1 - 4.
NeuronGraph two_parts() {
  return {6, {{3, 2}, {0, 2}, {5, 3}, {1, 4}, {2, 5}}};
}

TEST(NeuronGraph, OrdersItsEdges) {
  EXPECT_EQ(two_parts().edges(), (Edges{{0, 2}, {1, 4}, {2, 3}, {2, 5}, {3, 5}}));
  EXPECT_EQ(two_parts().neighbours(2), (Numbers{0, 3, 5}));
  EXPECT_EQ(two_parts().neighbours(4), (Numbers{1}));
}

TEST(NeuronGraph, CountsTheStepsOfShortestPaths) {
  const NeuronGraph graph = two_parts();
  EXPECT_EQ(graph.steps(0, 0), 0U);
  EXPECT_EQ(graph.steps(0, 3), 2U);
  EXPECT_EQ(graph.steps(5, 0), 2U);
  EXPECT_EQ(graph.steps(1, 4), 1U);
  EXPECT_FALSE(graph.steps(1, 5).has_value());
}

TEST(NeuronGraph, NumbersItsParts) {
  EXPECT_EQ(two_parts().parts(), (Numbers{0, 1, 0, 0, 1, 0}));
  EXPECT_EQ(NeuronGraph(3, {}).parts(), (Numbers{0, 1, 2}));
}

// Against all pairs by the rule of Floyd and Warshall.
TEST(NeuronGraph, HasTheStepsOfASlowSearch) {
  constexpr std::size_t kNone = 1000;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const std::size_t neurons = 1 + random.below(12);
    std::vector<Numbers> steps(neurons, Numbers(neurons, kNone));
    Edges edges;
    for (std::size_t a = 0; a < neurons; ++a) {
      steps[a][a] = 0;
      for (std::size_t b = a + 1; b < neurons; ++b) {
        if (random.below(4) > 0) continue;
        edges.emplace_back(a, b);
        steps[a][b] = steps[b][a] = 1;
      }
    }
    for (std::size_t by = 0; by < neurons; ++by) {
      for (std::size_t a = 0; a < neurons; ++a) {
        for (std::size_t b = 0; b < neurons; ++b) {
          steps[a][b] = std::min(steps[a][b], steps[a][by] + steps[by][b]);
        }
      }
    }
    const NeuronGraph graph(neurons, edges);
    for (std::size_t a = 0; a < neurons; ++a) {
      for (std::size_t b = 0; b < neurons; ++b) {
        EXPECT_EQ(graph.steps(a, b).value_or(kNone), steps[a][b]);
        EXPECT_EQ(graph.parts()[a] == graph.parts()[b], steps[a][b] < kNone);
      }
    }
  }
}

TEST(NeuronGraph, IsEqualForEqualEdges) {
  EXPECT_EQ(NeuronGraph(3, {{0, 1}}), NeuronGraph(3, {{1, 0}}));
  EXPECT_FALSE(NeuronGraph(3, {{0, 1}}) == NeuronGraph(3, {{0, 2}}));
  EXPECT_FALSE(NeuronGraph(3, {{0, 1}}) == NeuronGraph(4, {{0, 1}}));
}

TEST(NeuronGraph, RefusesEdgesThatAreNone) {
  EXPECT_THROW(NeuronGraph(3, {{1, 1}}), InvalidArgument);
  EXPECT_THROW(NeuronGraph(3, {{0, 3}}), InvalidArgument);
  EXPECT_THROW(NeuronGraph(3, {{0, 1}, {1, 0}}), InvalidArgument);
  EXPECT_THROW(NeuronGraph(NeuronGraph::kMostNeurons + 1, {}), InvalidArgument);
}

}  // namespace
}  // namespace somato
