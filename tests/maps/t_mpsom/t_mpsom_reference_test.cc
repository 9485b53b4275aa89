#include "maps/t_mpsom/t_mpsom_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/t_mpsom_by_hand.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using testing::ByHand;

void expect_near(std::span<const double> values, std::span<const double> expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-14) << i;
}

TMpsomReference by_hand(TMpsomCombination combination) {
  return TMpsomReference(ByHand::parameters(combination), ByHand::weights<double>());
}

TEST(TMpsomReference, IsRightByHandWhenMultiplied) {
  TMpsomReference map = by_hand(TMpsomCombination::kMultiplied);
  const auto activity = map.activation(ByHand::inputs<double>());
  expect_near(activity, ByHand::multiplied_activity());
  expect_near(map.neighbourhood(activity), ByHand::multiplied_neighbourhood());
  EXPECT_TRUE(map.learn(ByHand::inputs<double>(), ByHand::kAlpha));
  expect_near(map.weights(0).values(), ByHand::multiplied_weights()[0]);
  expect_near(map.weights(1).values(), ByHand::multiplied_weights()[1]);
}

TEST(TMpsomReference, IsRightByHandWhenAdded) {
  const TMpsomReference map = by_hand(TMpsomCombination::kAdded);
  const auto activity = map.activation(ByHand::inputs<double>());
  expect_near(activity, ByHand::added_activity());
  expect_near(map.neighbourhood(activity), ByHand::added_neighbourhood());
}

// Without norms the sample (3, 4) moves weights as it is: (1, 0) + 0.5 * (2, 4) = (2, 2).
TEST(TMpsomReference, LeavesVectorsAsTheyAreWithoutNorms) {
  TMpsomParameters parameters = ByHand::parameters(TMpsomCombination::kMultiplied);
  parameters.input_norm = TMpsomNorm::kNone;
  parameters.weight_norm = TMpsomNorm::kNone;
  TMpsomReference map(parameters, ByHand::weights<double>());
  expect_near(map.activation(ByHand::inputs<double>()), std::vector{6.0, 0.0, 2.4, 0.0});
  EXPECT_TRUE(map.learn(ByHand::inputs<double>(), ByHand::kAlpha));
  expect_near(map.weights(0).row(0), std::vector{2.0, 2.0});
}

// Four elements over two neurons: I/K = 1/2, so with indices from 1 the first neuron looks at
// element 2 and the second at element 4; counted from 0 it would be elements 1 and 3.
TEST(TMpsomReference, CountsIndicesFromOne) {
  TMpsomParameters parameters;
  parameters.shape = {2};
  parameters.input_sizes = {4};
  parameters.arbor_sigma = 0.5;
  const TMpsomReference map(parameters);
  const double half = std::exp(-0.5);  // distance 0.5, sigma 0.5
  const double one = std::exp(-2.0);   // distance 1
  expect_near(
      std::vector{map.arbor(0, 0, 0), map.arbor(0, 0, 1), map.arbor(0, 0, 2), map.arbor(0, 0, 3)},
      std::vector{half, 1.0, half, one});
  expect_near(std::vector{map.arbor(0, 1, 1), map.arbor(0, 1, 2), map.arbor(0, 1, 3)},
              std::vector{one, half, 1.0});
}

TEST(TMpsomReference, SpreadsEachInputAlongItsOwnAxis) {
  TMpsomParameters parameters;
  parameters.shape = {2, 3};
  parameters.input_sizes = {3, 2, 3};
  parameters.input_axes = {1, 0, 1};
  const TMpsomReference map(parameters);
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      EXPECT_EQ(map.arbor(0, row * 3 + column, column), 1.0);
      EXPECT_EQ(map.arbor(1, row * 3 + column, row), 1.0);
      EXPECT_EQ(map.arbor(2, row * 3 + column, column), 1.0);
    }
  }
}

TEST(TMpsomReference, StartsFromUniformWeightsOfUnitLength) {
  TMpsomParameters parameters;
  parameters.shape = {3, 2};
  parameters.input_sizes = {4, 2};
  parameters.seed = 8;
  const TMpsomReference map(parameters);
  for (std::uint32_t n = 0; n < 6; ++n) {
    const double first = uniform_at(8, Stream::kInitialWeights, n, 4);
    const double second = uniform_at(8, Stream::kInitialWeights, n, 5);
    const double length = std::hypot(first, second);
    expect_near(map.weights(1).row(n), std::vector{first / length, second / length});
  }
}

TEST(TMpsomReference, LearnsNothingWithoutActivity) {
  TMpsomReference map = by_hand(TMpsomCombination::kMultiplied);
  EXPECT_FALSE(map.learn({{3, 4}, {0, 0}}, 1.0));
  EXPECT_EQ(map.weights(0), ByHand::weights<double>()[0]);
  EXPECT_EQ(map.weights(1), ByHand::weights<double>()[1]);
}

TEST(TMpsomReference, CountsActivityBelowZeroAsNone) {
  const TMpsomReference map = by_hand(TMpsomCombination::kAdded);
  expect_near(map.neighbourhood({-3.0, 1.0, 0.0, -1.0}), std::vector{0.5, 1.0, 0.25, 0.5});
  expect_near(map.neighbourhood({-3.0, 0.0, -1.0, -1.0}), std::vector{0.0, 0.0, 0.0, 0.0});
}

TEST(TMpsomReference, RefusesWhatDoesNotFit) {
  EXPECT_THROW(TMpsomReference{TMpsomParameters{}}, InvalidArgument);
  const TMpsomParameters parameters = ByHand::parameters(TMpsomCombination::kAdded);
  EXPECT_THROW(TMpsomReference(parameters, {Matrix<double>(4, 2)}), InvalidArgument);
  EXPECT_THROW(TMpsomReference(parameters, {Matrix<double>(4, 2), Matrix<double>(4, 3)}),
               InvalidArgument);
  const TMpsomReference map(parameters);
  EXPECT_THROW(map.activation({{1, 2}}), InvalidArgument);
  EXPECT_THROW(map.activation({{1, 2}, {1, 2, 3}}), InvalidArgument);
}

}  // namespace
}  // namespace somato
