#include "maps/grid/neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

TEST(Neighbourhood, IsTheFunctionOfTheDistanceOnEveryGrid) {
  Random random(21);
  for (int i = 0; i < 400; ++i) {
    for (const auto& variant : testing::all_variants()) {
      const SomParameters p = testing::random_parameters(variant, random);
      const Grid grid = p.grid();
      Neighbourhood neighbourhood(grid, p.neighbourhood);
      std::vector<double> gains(grid.size());
      const std::size_t winner = random.below(grid.size());
      const double radius = 0.1 + 3.0 * random.uniform();
      neighbourhood.around(winner, radius, gains);
      for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
        const double square = grid.squared_distance(winner, neuron);
        const double expected = p.neighbourhood == NeighbourhoodShape::kBubble
                                    ? (std::sqrt(square) <= radius ? 1.0 : 0.0)
                                    : std::exp(-square / (2.0 * radius * radius));
        EXPECT_NEAR(gains[neuron], expected, 1e-12) << testing::name_of(variant);
      }
    }
  }
}

TEST(Neighbourhood, OfRadiusZeroIsOnlyTheWinner) {
  for (const auto shape : {NeighbourhoodShape::kGaussian, NeighbourhoodShape::kBubble}) {
    Neighbourhood neighbourhood(Grid(2, 2, Lattice::kHexagonal, Topology::kTorus), shape);
    std::vector<float> gains(4);
    neighbourhood.around(2, 0.0, gains);
    EXPECT_EQ(gains, (std::vector<float>{0, 0, 1, 0}));
  }
}

TEST(Neighbourhood, ABubbleOfRadiusOneHoldsTheSixHexagonalNeighbours) {
  const Grid grid(5, 5, Lattice::kHexagonal, Topology::kPlane);
  Neighbourhood neighbourhood(grid, NeighbourhoodShape::kBubble);
  for (const std::size_t winner : {12U, 7U}) {
    std::vector<float> gains(25);
    neighbourhood.around(winner, 1.0, gains);
    EXPECT_EQ(std::count(gains.begin(), gains.end(), 1.0F), 7);
  }
}

TEST(Neighbourhood, HasNoDenormalNumbers) {
  Neighbourhood neighbourhood(Grid(1, 60, Lattice::kRectangular, Topology::kPlane),
                              NeighbourhoodShape::kGaussian);
  std::vector<float> gains(60);
  neighbourhood.around(0, 1.0, gains);
  for (const float gain : gains) EXPECT_NE(std::fpclassify(gain), FP_SUBNORMAL);
  EXPECT_EQ(gains[59], 0.0F);
}

}  // namespace
}  // namespace somato
