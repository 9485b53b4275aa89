#include "maps/t_mpsom/t_mpsom_learner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/support/instruction_sets.h"
#include "maps/support/t_mpsom_problems.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// The oracle is TMpsom::learn(), which puts nothing off.

using testing::densified;
using testing::random_inputs;
using testing::random_parameters;
using testing::random_weights;
using testing::Sign;
using testing::views;

// Some steps of inputs of which many come again, whole or in part, and many are zero.
std::vector<std::vector<Signal>> random_steps(Random& random, const TMpsomParameters& p) {
  const Sign sign = random.below(2) ? Sign::kPositive : Sign::kEither;
  std::vector<std::vector<Signal>> kinds;
  for (int i = 0; i < 3; ++i) kinds.push_back(random_inputs(random, p, sign));
  std::vector<std::vector<Signal>> steps;
  for (int i = 0; i < 25; ++i) {
    std::vector<Signal> inputs;
    for (std::size_t a = 0; a < p.input_sizes.size(); ++a) {
      const bool is_zero = random.below(4) == 0;
      inputs.push_back(is_zero ? Signal::dense(std::vector<float>(p.input_sizes[a]))
                               : kinds[random.below(kinds.size())][a]);
    }
    steps.push_back(random.below(2) ? densified(inputs) : inputs);
  }
  return steps;
}

TMpsom random_map(Random& random, const TMpsomParameters& p) {
  if (random.below(2)) return TMpsom(p);
  return TMpsom::from_weights(p, random_weights(random, p, Sign::kEither)).value();
}

// It settles occasionally, and evaluates inputs without learning them.
void expect_plain_learning(Random& random, const TMpsomParameters& p) {
  TMpsom plain = random_map(random, p);
  TMpsom learned = plain;
  TMpsom::Workspace workspace(plain);
  TMpsomLearner learner(learned);
  std::vector<float> expected(plain.neurons());
  std::vector<float> activity(plain.neurons());
  for (const std::vector<Signal>& inputs : random_steps(random, p)) {
    const double alpha = random.below(10) == 0 ? 1.0 : random.uniform();
    if (random.below(2)) {
      plain.activation(views(inputs), workspace, expected);
      learner.activation(views(inputs), activity);
      ASSERT_EQ(activity, expected);
    }
    if (random.below(4) > 0) {
      const bool has_learned = plain.learn(views(inputs), alpha, workspace);
      ASSERT_EQ(learner.learn(views(inputs), alpha), has_learned);
    }
    if (random.below(5) > 0) continue;
    learner.settle();
    ASSERT_EQ(learned, plain);
  }
  learner.settle();
  ASSERT_EQ(learned, plain);
}

TEST(TMpsomLearner, LearnsTheSameBits) {
  Random random(61);
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    for (int problem = 0; problem < 200; ++problem) {
      expect_plain_learning(random, random_parameters(random));
    }
  });
}

TEST(TMpsomLearner, LearnsTheSameBitsOnLargerMaps) {
  Random random(62);
  for (const auto& [shape, sizes] :
       std::vector<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>>{
           {{46, 23}, {90, 45}}, {{9, 9}, {256, 3}}, {{9, 9}, {257, 3}}, {{1}, {1}}}) {
    TMpsomParameters p;
    p.shape = shape;
    p.input_sizes = sizes;
    for (const auto combination : {TMpsomCombination::kMultiplied, TMpsomCombination::kAdded}) {
      p.combination = combination;
      p.input_axes.clear();
      if (shape.size() < sizes.size()) p.input_axes = std::vector<std::size_t>(sizes.size(), 0);
      expect_plain_learning(random, p);
    }
  }
}

TEST(TMpsomLearner, SettlesAtItsEnd) {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  TMpsom map(p);
  TMpsom plain(p);
  const auto inputs = testing::dense({{1, 2, 3}, {1, 2}});
  EXPECT_TRUE(TMpsomLearner(map).learn(views(inputs), 0.5));
  EXPECT_TRUE(testing::learn(plain, inputs, 0.5));
  EXPECT_EQ(map, plain);
}

TEST(TMpsomLearner, RefusesWhatTheMapRefuses) {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  TMpsom map(p);
  TMpsomLearner learner(map);
  std::vector<float> few(5);
  const auto good = testing::dense({{1, 2, 3}, {1, 2}});
  EXPECT_THROW(learner.activation(views(good), few), InvalidArgument);
  EXPECT_THROW(learner.learn(views(good), 1.5), InvalidArgument);
  EXPECT_THROW(learner.learn(views(testing::dense({{1, 2}, {1, 2}})), 0.5), InvalidArgument);
  EXPECT_THROW(learner.learn(views(testing::dense({{1, std::nanf(""), 3}, {1, 2}})), 0.5),
               InvalidArgument);
  learner.settle();
  EXPECT_EQ(map, TMpsom(p));
}

}  // namespace
}  // namespace somato
