#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps/support/t_mpsom_problems.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"

namespace somato {
namespace {

// A workspace keeps partial activations. A fresh one is the oracle: it has none to keep.

using testing::activation;
using testing::dense;
using testing::densified;
using testing::random_inputs;
using testing::random_parameters;
using testing::Sign;
using testing::views;

std::vector<float> activation_with(const TMpsom& map, const std::vector<Signal>& inputs,
                                   TMpsom::Workspace& workspace) {
  std::vector<float> activity(map.neurons());
  map.activation(views(inputs), workspace, activity);
  return activity;
}

TMpsomParameters small_parameters() {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  p.input_norm = TMpsomNorm::kNone;
  return p;
}

// The problems have two kinds of inputs, maps and forms, in any order; learning in between.
TEST(TMpsomWorkspace, GivesWhatAFreshOneGives) {
  Random random(51);
  for (int problem = 0; problem < 300; ++problem) {
    const TMpsomParameters p = random_parameters(random);
    std::vector<TMpsom> maps{TMpsom(p), TMpsom(p)};
    TMpsom::Workspace workspace(maps[0]);
    const std::vector<std::vector<Signal>> seen{random_inputs(random, p, Sign::kEither),
                                                random_inputs(random, p, Sign::kEither)};
    for (int step = 0; step < 20; ++step) {
      std::vector<Signal> inputs = seen[random.below(2)];
      inputs[0] = seen[random.below(2)][0];
      if (random.below(2)) inputs = densified(inputs);
      TMpsom& map = maps[random.below(2)];
      const auto what = random.below(4);
      if (what == 0) {
        TMpsom fresh = map;
        const bool learned = testing::learn(fresh, inputs, 0.5);
        EXPECT_EQ(map.learn(views(inputs), 0.5, workspace), learned);
        ASSERT_EQ(map, fresh);
      } else if (what == 1) {
        map = maps[random.below(2)];
      }
      ASSERT_EQ(activation_with(map, inputs, workspace), activation(map, inputs));
    }
  }
}

TEST(TMpsomWorkspace, ForgetsWhatWasBeforeLearning) {
  TMpsom map(small_parameters());
  TMpsom::Workspace workspace(map);
  TMpsom::Workspace other(map);
  const auto inputs = dense({{1, 2, 3}, {1, 2}});
  const auto before = activation_with(map, inputs, workspace);
  EXPECT_TRUE(map.learn(views(inputs), 0.5, other));
  const auto after = activation_with(map, inputs, workspace);
  EXPECT_NE(after, before);
  EXPECT_EQ(after, activation(map, inputs));
}

TEST(TMpsomWorkspace, DistinguishesACopyThatLearnedFromItsOriginal) {
  const TMpsom original(small_parameters());
  TMpsom copy = original;
  TMpsom::Workspace workspace(original);
  const auto inputs = dense({{1, 2, 3}, {1, 2}});
  const auto before = activation_with(original, inputs, workspace);
  EXPECT_EQ(activation_with(copy, inputs, workspace), before);
  EXPECT_TRUE(testing::learn(copy, inputs, 0.5));
  EXPECT_EQ(activation_with(copy, inputs, workspace), activation(copy, inputs));
  EXPECT_EQ(activation_with(original, inputs, workspace), before);
}

TEST(TMpsomWorkspace, DistinguishesMapsWithGivenWeights) {
  const TMpsom ones =
      *TMpsom::from_weights(small_parameters(), {Matrix<float>(6, 3, 1), Matrix<float>(6, 2, 1)});
  const TMpsom twos =
      *TMpsom::from_weights(small_parameters(), {Matrix<float>(6, 3, 2), Matrix<float>(6, 2, 1)});
  TMpsom::Workspace workspace(ones);
  const auto inputs = dense({{1, 2, 3}, {1, 2}});
  const auto of_ones = activation_with(ones, inputs, workspace);
  const auto of_twos = activation_with(twos, inputs, workspace);
  for (std::size_t n = 0; n < of_ones.size(); ++n) EXPECT_EQ(of_twos[n], 2 * of_ones[n]);
}

TEST(TMpsomWorkspace, SeesASingleBit) {
  const TMpsom map(small_parameters());
  TMpsom::Workspace workspace(map);
  const float more = std::nextafter(2.0F, 3.0F);
  activation_with(map, dense({{0, 2, 0}, {1, 2}}), workspace);
  const auto inputs = dense({{0, more, 0}, {1, 2}});
  EXPECT_EQ(activation_with(map, inputs, workspace), activation(map, inputs));
  const auto moved = dense({{more, 0, 0}, {1, 2}});
  EXPECT_EQ(activation_with(map, moved, workspace), activation(map, moved));
  const auto opposite = dense({{-more, 0, 0}, {1, 2}});
  EXPECT_EQ(activation_with(map, opposite, workspace), activation(map, opposite));
}

// Zeros of either sign, stored or not, are one input.
TEST(TMpsomWorkspace, TakesAllZerosAsOne) {
  const TMpsom map(small_parameters());
  TMpsom::Workspace workspace(map);
  const auto expected = activation(map, dense({{0, 2, 0}, {1, 2}}));
  const Signal second = Signal::dense({1, 2});
  EXPECT_EQ(activation_with(map, dense({{-0.0F, 2, 0}, {1, 2}}), workspace), expected);
  EXPECT_EQ(activation_with(map, {Signal::sparse({3}, {1}, {2}), second}, workspace), expected);
  EXPECT_EQ(activation_with(map, {Signal::sparse({3}, {0, 1}, {0, 2}), second}, workspace),
            expected);
  TMpsom::Workspace fresh(map);
  const auto zeros = dense({{0, 0, 0}, {-0.0F, 0}});
  for (const float y : activation_with(map, zeros, fresh)) EXPECT_EQ(y, 0.0F);
}

// A refused input must not be taken for the last one when it comes again.
TEST(TMpsomWorkspace, RefusesTheSameInputTwice) {
  const TMpsom map(small_parameters());
  TMpsom::Workspace workspace(map);
  const auto good = dense({{1, 2, 3}, {1, 2}});
  const auto expected = activation_with(map, good, workspace);
  for (const float bad : {std::numeric_limits<float>::infinity(), std::nanf("")}) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_THROW(activation_with(map, dense({{1, bad, 3}, {1, 2}}), workspace), InvalidArgument);
    }
    EXPECT_EQ(activation_with(map, good, workspace), expected);
  }
}

}  // namespace
}  // namespace somato
