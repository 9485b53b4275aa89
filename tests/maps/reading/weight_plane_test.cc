#include "maps/reading/weight_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace somato {
namespace {

Som map_with(std::size_t rows, std::size_t columns, Matrix<float> weights) {
  SomParameters parameters;
  parameters.rows = rows;
  parameters.columns = columns;
  const auto features = weights.columns();
  return Som(*resolve(parameters, 10, features), weights);
}

// Neurons on a rectangle: the long side is the first axis, with 9 of 10 parts of the variance.
TEST(WeightPlane, HasTheAxesOfARectangleInSpace) {
  const Som som = map_with(2, 2, Matrix<float>(4, 3, {-3, 5, -1, 3, 5, -1, -3, 5, 1, 3, 5, 1}));
  const WeightPlane plane(som);
  EXPECT_NEAR(plane.axes()[0][0], 1.0, 1e-9);
  EXPECT_NEAR(plane.axes()[1][2], 1.0, 1e-9);
  EXPECT_NEAR(plane.shares()[0], 0.9, 1e-9);
  EXPECT_NEAR(plane.shares()[1], 0.1, 1e-9);
  EXPECT_NEAR(plane.neurons()[1].x, 3.0, 1e-6);
  EXPECT_NEAR(plane.neurons()[1].y, -1.0, 1e-6);
}

TEST(WeightPlane, ProjectsSamples) {
  const Som som = map_with(2, 2, Matrix<float>(4, 3, {-3, 5, -1, 3, 5, -1, -3, 5, 1, 3, 5, 1}));
  const auto at = WeightPlane(som).positions_of(som, Samples(Matrix<float>(1, 3, {2, 7, 4})));
  ASSERT_EQ(at.size(), 1U);
  EXPECT_NEAR(at[0].x, 2.0, 1e-6);
  EXPECT_NEAR(at[0].y, 4.0, 1e-6);
}

TEST(WeightPlane, OfOneNeuronOrEqualOnesIsAPoint) {
  for (const std::size_t neurons : {1U, 3U}) {
    const Som som =
        map_with(1, neurons, Matrix<float>(neurons, 2, std::vector<float>(2 * neurons, 4)));
    const WeightPlane plane(som);
    EXPECT_EQ(plane.shares()[0], 0.0);
    EXPECT_EQ(plane.axes()[0][0], 0.0);
    EXPECT_EQ(plane.neurons().back().x, 0.0);
  }
}

}  // namespace
}  // namespace somato
