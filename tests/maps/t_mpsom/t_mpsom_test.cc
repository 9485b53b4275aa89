#include "somato/maps/t_mpsom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps/support/t_mpsom_by_hand.h"
#include "maps/support/t_mpsom_problems.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using testing::activation;
using testing::ByHand;
using testing::dense;
using testing::learn;
using testing::length;
using testing::views;

template <typename Values>
void expect_near(const Values& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(double{values[i]}, expected[i], 3e-7) << i;
  }
}

TEST(TMpsom, IsRightByHand) {
  const auto inputs = dense(ByHand::inputs<float>());
  auto map = TMpsom::from_weights(ByHand::parameters(TMpsomCombination::kMultiplied),
                                  ByHand::weights<float>());
  ASSERT_TRUE(map);
  expect_near(activation(*map, inputs), ByHand::multiplied_activity());
  TMpsom::Workspace workspace(*map);
  EXPECT_TRUE(map->learn(views(inputs), ByHand::kAlpha, workspace));
  expect_near(workspace.neighbourhood(), ByHand::multiplied_neighbourhood());
  const Matrix<float> first = map->weights(0);
  const Matrix<float> second = map->weights(1);
  expect_near(first.values(), ByHand::multiplied_weights()[0]);
  expect_near(second.values(), ByHand::multiplied_weights()[1]);
}

TEST(TMpsom, IsRightByHandWhenAdded) {
  auto map =
      TMpsom::from_weights(ByHand::parameters(TMpsomCombination::kAdded), ByHand::weights<float>());
  ASSERT_TRUE(map);
  const auto inputs = dense(ByHand::inputs<float>());
  TMpsom::Workspace workspace(*map);
  EXPECT_TRUE(map->learn(views(inputs), ByHand::kAlpha, workspace));
  expect_near(workspace.activity(), ByHand::added_activity());
  expect_near(workspace.neighbourhood(), ByHand::added_neighbourhood());
}

// As in the reference's test: from 0 the first neuron would look at element 1, not 2.
TEST(TMpsom, CountsIndicesFromOne) {
  TMpsomParameters parameters;
  parameters.shape = {2};
  parameters.input_sizes = {4};
  parameters.arbor_sigma = 0.5;
  const Matrix<float> arbor = TMpsom(parameters).arbor(0);
  const double half = std::exp(-0.5);  // distance 0.5, sigma 0.5
  const double one = std::exp(-2.0);   // distance 1
  const double far = std::exp(-4.5);   // distance 1.5
  expect_near(arbor.values(), {half, 1.0, half, one, far, one, half, 1.0});
}

TMpsomParameters small() {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  return p;
}

TEST(TMpsom, StartsFromUniformWeights) {
  TMpsomParameters p = small();
  p.weight_norm = TMpsomNorm::kNone;
  p.seed = 5;
  const TMpsom map(p);
  EXPECT_EQ(map.weights(0)(4, 2), uniform_at(5, Stream::kInitialWeights, 4, 2));
  EXPECT_EQ(map.weights(1)(4, 1), uniform_at(5, Stream::kInitialWeights, 4, 4));
}

TEST(TMpsom, KeepsAZeroVectorZero) {
  const std::vector<Matrix<float>> zeros{Matrix<float>(6, 3), Matrix<float>(6, 2, 0.5F)};
  TMpsomParameters p = small();
  p.combination = TMpsomCombination::kAdded;
  TMpsom map = *TMpsom::from_weights(p, zeros);
  EXPECT_TRUE(learn(map, dense({{0, 0, 0}, {1, 2}}), 0.5));
  EXPECT_EQ(map.weights(0), zeros[0]);
  EXPECT_NE(map.weights(1), zeros[1]);
}

// The strength of a normalized input does not matter, however far it is from 1.
TEST(TMpsom, NormalizesInputsOfAnyStrength) {
  const TMpsom map(small());
  const auto expected = activation(map, dense({{1, 2, 3}, {2, 1}}));
  for (const float strength : {1e-35F, 1e-20F, 1e20F, 1e37F}) {
    const auto activity =
        activation(map, dense({{strength, 2 * strength, 3 * strength}, {2 * strength, strength}}));
    for (std::size_t n = 0; n < expected.size(); ++n) {
      EXPECT_NEAR(activity[n], expected[n], 1e-5F * expected[n]) << strength;
    }
  }
}

// Squares of such weights are beyond float.
TEST(TMpsom, NormalizesWeightsOfAnyLength) {
  TMpsomParameters p = small();
  p.input_norm = TMpsomNorm::kNone;
  p.combination = TMpsomCombination::kAdded;
  for (const float strength : {1e-17F, 3e19F}) {
    TMpsom map =
        *TMpsom::from_weights(p, {Matrix<float>(6, 3, strength), Matrix<float>(6, 2, 1.0F)});
    EXPECT_TRUE(learn(map, dense({{strength / 10, 0, 0}, {0, 1}}), 0.5));
    const Matrix<float> weights = map.weights(0);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(length(weights.row(n)), 1.0, 1e-6) << strength;
  }
}

TEST(TMpsom, TakesTheFirstOfEqualWinners) {
  EXPECT_EQ(TMpsom::winner(std::vector{0.1F, 0.7F, 0.3F, 0.7F}), 1U);
  EXPECT_EQ(TMpsom::winner(std::vector{-0.7F, -0.1F}), 1U);
  EXPECT_THROW(TMpsom::winner({}), InvalidArgument);
}

TEST(TMpsom, RefusesInputsThatDoNotFit) {
  TMpsom map(small());
  const TMpsom before = map;
  EXPECT_THROW(activation(map, dense({{1, 2, 3}})), InvalidArgument);
  EXPECT_THROW(activation(map, dense({{1, 2, 3}, {1, 2, 3}})), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2}, {1, 2}}), 0.1), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, 2}}), 1.1), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, 2}}), -0.1), InvalidArgument);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_THROW(activation(map, dense({{1, nan, 3}, {1, 2}})), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, infinity}}), 0.1), InvalidArgument);
  EXPECT_EQ(map, before);
}

TEST(TMpsom, RefusesActivityBeyondNumbers) {
  TMpsomParameters p = small();
  p.input_norm = TMpsomNorm::kNone;
  p.weight_norm = TMpsomNorm::kNone;
  TMpsom map = *TMpsom::from_weights(p, {Matrix<float>(6, 3, 1e30F), Matrix<float>(6, 2, 1.0F)});
  const TMpsom before = map;
  EXPECT_THROW(learn(map, dense({{1e30F, 0, 0}, {1, 1}}), 0.5), InvalidArgument);
  EXPECT_EQ(map, before);
}

TEST(TMpsom, RefusesTheWorkspaceOfAnotherMap) {
  TMpsom map(small());
  TMpsomParameters other = small();
  other.shape = {2, 2};
  TMpsom::Workspace workspace{TMpsom(other)};
  std::vector<float> activity(6);
  const auto inputs = dense({{1, 2, 3}, {1, 2}});
  EXPECT_THROW(map.activation(views(inputs), workspace, activity), InvalidArgument);
  TMpsom::Workspace own(map);
  activity.resize(5);
  EXPECT_THROW(map.activation(views(inputs), own, activity), InvalidArgument);
}

TEST(TMpsom, IsTheSameFromItsOwnWeights) {
  TMpsom map(small());
  learn(map, dense({{1, 2, 3}, {1, 2}}), 0.5);
  const auto again = TMpsom::from_weights(map.parameters(), {map.weights(0), map.weights(1)});
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, map);
  EXPECT_FALSE(*again == TMpsom(small()));
  EXPECT_THROW(map.weights(2), InvalidArgument);
  EXPECT_THROW(map.arbor(2), InvalidArgument);
}

void expect_refused(const std::vector<Matrix<float>>& weights, const std::string& what) {
  const auto map = TMpsom::from_weights(small(), weights);
  ASSERT_FALSE(map) << what;
  EXPECT_EQ(map.error().kind, ErrorKind::kData);
  EXPECT_EQ(map.error().what, what);
}

TEST(TMpsom, RefusesWeightsThatDoNotFit) {
  expect_refused({Matrix<float>(6, 3)}, "weights for 1 inputs given, but the T-MPSOM has 2");
  expect_refused({Matrix<float>(6, 3), Matrix<float>(6, 3)},
                 "the weights of input 1 are 6 x 3, not 6 x 2");
  expect_refused({Matrix<float>(5, 3), Matrix<float>(6, 2)},
                 "the weights of input 0 are 5 x 3, not 6 x 3");
  expect_refused({Matrix<float>(6, 3), Matrix<float>(6, 2, std::nanf(""))},
                 "a weight of input 1 is not finite");
  const auto map = TMpsom::from_weights(TMpsomParameters{}, {});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::kUsage);
  EXPECT_THROW(TMpsom{TMpsomParameters{}}, InvalidArgument);
}

}  // namespace
}  // namespace somato
