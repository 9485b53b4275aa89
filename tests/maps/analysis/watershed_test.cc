#include "maps/analysis/watershed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "somato/core/random.h"
#include "somato/maps/grid.h"

namespace somato {
namespace {

using Vertices = std::vector<std::size_t>;

std::vector<Vertices> edges_of(const Grid& grid) {
  std::vector<Vertices> edges;
  for (std::size_t i = 0; i < grid.size(); ++i) edges.push_back(grid.neighbours(i));
  return edges;
}

std::vector<Vertices> line_edges(std::size_t count) {
  return edges_of(Grid(1, count, Lattice::kRectangular, Topology::kPlane));
}

// A ridge goes to its lower neighbour, or to the one of the lower number.
TEST(Watershed, FindsTheBasinsOfALine) {
  EXPECT_EQ(basins({2, 1, 2, 5, 1.5, 0, 1}, line_edges(7)), (Vertices{0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(basins({2, 1, 2, 5, 2, 0, 1}, line_edges(7)), (Vertices{0, 0, 0, 0, 1, 1, 1}));
}

// A plateau of 3 is divided in the middle.
TEST(Watershed, DividesPlateausBySteps) {
  EXPECT_EQ(basins({0, 3, 3, 3, 3, 1}, line_edges(6)), (Vertices{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(basins({0, 3, 3, 3, 1}, line_edges(5)), (Vertices{0, 0, 0, 1, 1}));
}

// A plateau of any form is one basin.
TEST(Watershed, JoinsAPlateau) {
  const Grid grid(3, 3, Lattice::kRectangular, Topology::kPlane);
  EXPECT_EQ(basins({1, 9, 1, 1, 9, 1, 1, 1, 1}, edges_of(grid)), Vertices(9, 0));
  EXPECT_EQ(basins(std::vector<double>(9, 4.0), edges_of(grid)), Vertices(9, 0));
}

TEST(Watershed, FillsTheShallowestBasins) {
  const std::vector<double> heights{0, 6, 4, 5, 1, 9, 2};
  EXPECT_EQ(basins(heights, line_edges(7)), (Vertices{0, 0, 1, 2, 2, 2, 3}));
  EXPECT_EQ(basins(heights, line_edges(7), 3), (Vertices{0, 0, 1, 1, 1, 1, 2}));
  EXPECT_EQ(basins(heights, line_edges(7), 2), (Vertices{0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(basins(heights, line_edges(7), 1), Vertices(7, 0));
  // The basins of 17 and 18 are high, but shallower than those of 0 and 1.
  EXPECT_EQ(basins({0, 5, 1, 20, 18, 19, 17}, line_edges(7), 3), (Vertices{0, 0, 1, 1, 2, 2, 2}));
}

TEST(Watershed, KeepsPartsWithoutAnEdge) {
  EXPECT_EQ(basins({1, 2}, {{}, {}}, 1), (Vertices{0, 1}));
  EXPECT_EQ(basins({1}, {{}}), Vertices{0});
}

// Every basin is connected, has one lowest plateau, and every vertex has a path down to it.
TEST(Watershed, OfRandomHeightsHasOneBasinForEachMinimum) {
  Random random(31);
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
      const Grid grid(6, 7, lattice, topology);
      std::vector<double> heights;
      for (std::size_t i = 0; i < grid.size(); ++i) heights.push_back(random.uniform());
      const Vertices found = basins(heights, edges_of(grid));
      std::size_t minima = 0;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const Vertices around = grid.neighbours(i);
        const auto lowest = *std::min_element(
            around.begin(), around.end(),
            [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
        if (heights[lowest] > heights[i]) {
          ++minima;
        } else {
          EXPECT_EQ(found[i], found[lowest]);
        }
      }
      EXPECT_EQ(*std::max_element(found.begin(), found.end()) + 1, minima);
    }
  }
}

}  // namespace
}  // namespace somato
