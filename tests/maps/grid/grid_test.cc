#include "somato/maps/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(Grid, MeasuresDistancesOnThePlane) {
  const Grid grid(3, 4, Lattice::kRectangular, Topology::kPlane);
  EXPECT_EQ(grid.squared_distance(0, 11), 3.0 * 3.0 + 2.0 * 2.0);
  EXPECT_EQ(grid.squared_distance(5, 5), 0.0);
}

TEST(Grid, GoesTheShortWayRoundATorus) {
  const Grid grid(3, 4, Lattice::kRectangular, Topology::kTorus);
  EXPECT_EQ(grid.squared_distance(0, 3), 1.0);   // one column back
  EXPECT_EQ(grid.squared_distance(0, 8), 1.0);   // one row up
  EXPECT_EQ(grid.squared_distance(0, 2), 4.0);   // half way round either way
  EXPECT_EQ(grid.squared_distance(0, 11), 2.0);  // both
}

TEST(Grid, HexagonalNeighboursAreSixAtDistanceOne) {
  for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
    const Grid grid(6, 5, Lattice::kHexagonal, topology);
    for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
      const auto neighbours = grid.neighbours(neuron);
      for (const std::size_t other : neighbours) {
        EXPECT_NEAR(grid.squared_distance(neuron, other), 1.0, 1e-12);
      }
      const std::size_t row = grid.row_of(neuron);
      const std::size_t column = grid.column_of(neuron);
      const bool inside = row > 0 && row < 5 && column > 0 && column < 4;
      if (inside || topology == Topology::kTorus) {
        EXPECT_EQ(neighbours.size(), 6U) << neuron;
      }
    }
  }
}

TEST(Grid, HexagonalOddRowsAreShiftedRight) {
  const Grid grid(3, 3, Lattice::kHexagonal, Topology::kPlane);
  EXPECT_EQ(grid.neighbours(4), (std::vector<std::size_t>{1, 2, 3, 5, 7, 8}));
  EXPECT_EQ(grid.neighbours(0), (std::vector<std::size_t>{1, 3}));
  EXPECT_DOUBLE_EQ(grid.position(4).x, 1.5);
  EXPECT_DOUBLE_EQ(grid.position(4).y, std::sqrt(3.0) / 2.0);
}

TEST(Grid, RectangularNeighboursShareAnEdge) {
  const Grid plane(3, 3, Lattice::kRectangular, Topology::kPlane);
  EXPECT_EQ(plane.neighbours(4), (std::vector<std::size_t>{1, 3, 5, 7}));
  EXPECT_EQ(plane.neighbours(0), (std::vector<std::size_t>{1, 3}));
  const Grid torus(3, 3, Lattice::kRectangular, Topology::kTorus);
  EXPECT_EQ(torus.neighbours(0), (std::vector<std::size_t>{1, 2, 3, 6}));
}

TEST(Grid, NeighboursAreThoseThatAreAdjacentOnEverySmallGrid) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
      for (std::size_t rows = 1; rows <= 6; ++rows) {
        for (std::size_t columns = 1; columns <= 6; ++columns) {
          if (!Grid::validate(rows, columns, lattice, topology)) continue;
          const Grid grid(rows, columns, lattice, topology);
          for (std::size_t a = 0; a < grid.size(); ++a) {
            std::vector<std::size_t> adjacent;
            for (std::size_t b = 0; b < grid.size(); ++b) {
              EXPECT_EQ(grid.squared_distance(a, b), grid.squared_distance(b, a));
              if (grid.adjacent(a, b)) adjacent.push_back(b);
            }
            EXPECT_EQ(grid.neighbours(a), adjacent) << rows << "x" << columns;
          }
        }
      }
    }
  }
}

// On a torus every neuron sees the same map: the distances from one are those from any other.
TEST(Grid, ATorusLooksTheSameFromEverywhere) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    const Grid grid(4, 5, lattice, Topology::kTorus);
    const auto distances_from = [&](std::size_t neuron) {
      std::vector<long> distances;
      for (std::size_t other = 0; other < grid.size(); ++other) {
        distances.push_back(std::lround(1e9 * grid.squared_distance(neuron, other)));
      }
      std::sort(distances.begin(), distances.end());
      return distances;
    };
    for (std::size_t neuron = 1; neuron < grid.size(); ++neuron) {
      EXPECT_EQ(distances_from(neuron), distances_from(0)) << neuron;
    }
  }
}

TEST(Grid, RefusesWhatCannotBe) {
  const auto rejects = [](std::size_t rows, std::size_t columns, Lattice lattice) {
    const auto valid = Grid::validate(rows, columns, lattice, Topology::kTorus);
    return valid ? std::string() : to_string(valid.error());
  };
  EXPECT_NE(rejects(0, 3, Lattice::kRectangular).find("at least one row"), std::string::npos);
  EXPECT_NE(rejects(5, 4, Lattice::kHexagonal).find("even number of rows, not 5"),
            std::string::npos);
  EXPECT_NE(rejects(1 << 20, 1 << 20, Lattice::kRectangular).find("more than"), std::string::npos);
  EXPECT_EQ(rejects(5, 4, Lattice::kRectangular), "");
  EXPECT_THROW(Grid(3, 3, Lattice::kHexagonal, Topology::kTorus), InvalidArgument);
}

// 0 - 1 - 2, and 3 apart.
TEST(Grid, MeasuresAGraphByItsEdges) {
  const Grid grid(
      std::make_shared<const NeuronGraph>(4, std::vector<NeuronGraph::Edge>{{0, 1}, {1, 2}}));
  EXPECT_EQ(grid.size(), 4U);
  EXPECT_EQ(grid.squared_distance(0, 2), 4.0);
  EXPECT_TRUE(std::isinf(grid.squared_distance(0, 3)));
  EXPECT_TRUE(grid.adjacent(2, 1));
  EXPECT_FALSE(grid.adjacent(2, 0));
  EXPECT_EQ(grid.neighbours(1), (std::vector<std::size_t>{0, 2}));
  EXPECT_NE(grid, Grid(1, 4, Lattice::kRectangular, Topology::kPlane));
  EXPECT_NE(grid, Grid(std::make_shared<const NeuronGraph>(4, std::vector<NeuronGraph::Edge>{})));
  EXPECT_THROW(Grid(std::make_shared<const NeuronGraph>(0, std::vector<NeuronGraph::Edge>{})),
               InvalidArgument);
}

}  // namespace
}  // namespace somato
