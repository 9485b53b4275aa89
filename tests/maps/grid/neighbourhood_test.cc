#include "maps/grid/neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

double neighbourhood_by_formula(NeighbourhoodShape shape, double distance, double radius) {
  const double ratio = distance / radius;
  const double gaussian = std::exp(-0.5 * ratio * ratio);
  switch (shape) {
    case NeighbourhoodShape::kGaussian:
      return gaussian;
    case NeighbourhoodShape::kBubble:
      return ratio <= 1.0 ? 1.0 : 0.0;
    case NeighbourhoodShape::kCutGaussian:
      return ratio <= 1.0 ? gaussian : 0.0;
    case NeighbourhoodShape::kTriangular:
      return ratio <= 1.0 ? 1.0 - ratio : 0.0;
    case NeighbourhoodShape::kEpanechnikov:
      return ratio <= 1.0 ? 1.0 - ratio * ratio : 0.0;
    case NeighbourhoodShape::kMexicanHat:
      return (1.0 - ratio * ratio) * gaussian;
  }
  return std::nan("");
}

TEST(Neighbourhood, IsTheFunctionOfTheDistanceOnEveryGrid) {
  Random random(21);
  for (int i = 0; i < 400; ++i) {
    for (const auto& variant : testing::all_variants()) {
      const SomParameters p = testing::random_parameters(variant, random);
      const Grid grid = p.grid();
      const auto& shapes = Choices<NeighbourhoodShape>::all();
      const NeighbourhoodShape shape = shapes[random.below(shapes.size())].first;
      Neighbourhood neighbourhood(grid, shape);
      std::vector<double> gains(grid.size());
      const std::size_t winner = random.below(grid.size());
      const double radius = 0.1 + 3.0 * random.uniform();
      neighbourhood.around(winner, radius, gains);
      for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
        const double distance = std::sqrt(grid.squared_distance(winner, neuron));
        EXPECT_NEAR(gains[neuron], neighbourhood_by_formula(shape, distance, radius), 1e-12)
            << choice_name(shape) << testing::name_of(variant);
      }
    }
  }
}

// Distances 0, 1, 2 and 3.
TEST(Neighbourhood, HasTheValuesOfItsFormula) {
  const Grid grid(1, 4, Lattice::kRectangular, Topology::kPlane);
  const auto values = [&](NeighbourhoodShape shape) {
    std::vector<double> gains(4);
    Neighbourhood(grid, shape).around(0, 2.0, gains);
    return gains;
  };
  const double at_half = 0.8824969025845955;  // exp(-1/8)
  const double at_radius = 0.6065306597126334;
  const auto expect = [&](NeighbourhoodShape shape, const std::vector<double>& expected) {
    const std::vector<double> found = values(shape);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 1e-15);
  };
  expect(NeighbourhoodShape::kCutGaussian, {1, at_half, at_radius, 0});
  expect(NeighbourhoodShape::kTriangular, {1, 0.5, 0, 0});
  expect(NeighbourhoodShape::kEpanechnikov, {1, 0.75, 0, 0});
  expect(NeighbourhoodShape::kMexicanHat, {1, 0.75 * at_half, 0, -1.25 * std::exp(-1.125)});
}

TEST(Neighbourhood, OfRadiusZeroIsOnlyTheWinner) {
  for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
    Neighbourhood neighbourhood(Grid(2, 2, Lattice::kHexagonal, Topology::kTorus), shape);
    for (const double radius : {0.0, 1e-200}) {
      std::vector<float> gains(4);
      neighbourhood.around(2, radius, gains);
      EXPECT_EQ(gains, (std::vector<float>{0, 0, 1, 0})) << name;
    }
  }
}

TEST(Neighbourhood, OfAVeryLargeRadiusIsOneEverywhere) {
  for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
    Neighbourhood neighbourhood(Grid(2, 2, Lattice::kHexagonal, Topology::kTorus), shape);
    std::vector<float> gains(4);
    neighbourhood.around(2, 1e200, gains);
    EXPECT_EQ(gains, std::vector<float>(4, 1.0F)) << name;
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
  for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
    Neighbourhood neighbourhood(Grid(1, 60, Lattice::kRectangular, Topology::kPlane), shape);
    std::vector<float> gains(60);
    neighbourhood.around(0, 1.0, gains);
    for (const float gain : gains) EXPECT_NE(std::fpclassify(gain), FP_SUBNORMAL) << name;
    EXPECT_EQ(gains[59], 0.0F);
  }
}

}  // namespace
}  // namespace somato
