#include "somato/maps/t_mpsom.h"

#include <gtest/gtest.h>

#include "base/support/instruction_sets.h"
#include "base/support/no_malloc.h"
#include "maps/support/t_mpsom_problems.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using testing::activation;
using testing::cosine;
using testing::densified;
using testing::learn;
using testing::length;
using testing::random_inputs;
using testing::random_value;
using testing::Sign;
using testing::views;

// Every combination, norm and kind of grid.
std::vector<TMpsomParameters> variants() {
  std::vector<TMpsomParameters> all;
  for (const auto& [combination, name] : Choices<TMpsomCombination>::all()) {
    for (const TMpsomNorm input_norm : {TMpsomNorm::kL2, TMpsomNorm::kNone}) {
      for (const TMpsomNorm weight_norm : {TMpsomNorm::kL2, TMpsomNorm::kNone}) {
        TMpsomParameters p;
        p.combination = combination;
        p.input_norm = input_norm;
        p.weight_norm = weight_norm;
        p.neighbourhood_sigma = 2.0;
        p.shape = {9, 5};
        p.input_sizes = {18, 10};
        all.push_back(p);
        p.shape = {7};
        p.input_sizes = {14, 7};
        p.input_axes = {0, 0};
        all.push_back(p);
        p.shape = {4, 3, 5};
        p.input_sizes = {8, 300, 10, 3};
        p.input_axes = {0, 1, 2, 1};
        all.push_back(p);
      }
    }
  }
  return all;
}

TEST(TMpsomLaws, AnUpdateMovesNoWeightsAwayFromTheirSample) {
  Random random(31);
  for (const TMpsomParameters& p : variants()) {
    TMpsom map(p);
    for (int step = 0; step < 10; ++step) {
      std::vector<Signal> inputs;
      for (const std::size_t size : p.input_sizes) {
        std::vector<float> values(size);
        for (float& value : values) value = random_value(random, Sign::kPositive);
        inputs.push_back(Signal::dense(values));
      }
      const TMpsom before = map;
      const std::size_t winner = TMpsom::winner(activation(before, inputs));
      ASSERT_TRUE(learn(map, inputs, 0.3));
      for (std::size_t a = 0; a < inputs.size(); ++a) {
        const Matrix<float> old_weights = before.weights(a);
        const Matrix<float> new_weights = map.weights(a);
        for (std::size_t n = 0; n < map.neurons(); ++n) {
          const double old_cosine = cosine(old_weights.row(n), inputs[a].values());
          const double new_cosine = cosine(new_weights.row(n), inputs[a].values());
          EXPECT_GE(new_cosine, old_cosine - 1e-6);
          if (n == winner && old_cosine < 0.999) {
            EXPECT_GT(new_cosine, old_cosine);
          }
        }
      }
    }
  }
}

TEST(TMpsomLaws, WeightsStayOfUnitLength) {
  Random random(32);
  for (const TMpsomParameters& p : variants()) {
    if (p.weight_norm == TMpsomNorm::kNone) continue;
    TMpsom map(p);
    for (int step = 0; step < 30; ++step) {
      learn(map, random_inputs(random, p, Sign::kEither), random.uniform());
      for (std::size_t a = 0; a < p.input_sizes.size(); ++a) {
        const Matrix<float> weights = map.weights(a);
        for (std::size_t n = 0; n < weights.rows(); ++n) {
          EXPECT_NEAR(length(weights.row(n)), 1.0, 1e-6);
        }
      }
    }
  }
}

TEST(TMpsomLaws, NothingIsLearnedWithoutActivity) {
  Random random(33);
  for (const TMpsomParameters& p : variants()) {
    auto inputs = random_inputs(random, p, Sign::kPositive);
    if (p.combination == TMpsomCombination::kMultiplied) {
      inputs.back() = Signal::dense(std::vector<float>(p.input_sizes.back()));
    } else {
      for (std::size_t a = 0; a < inputs.size(); ++a) {  // only negative activity
        inputs[a] = Signal::dense(std::vector<float>(p.input_sizes[a], -1.0F));
      }
    }
    TMpsom map(p);
    TMpsom::Workspace workspace(map);
    EXPECT_FALSE(map.learn(views(inputs), 0.5, workspace));
    EXPECT_EQ(map, TMpsom(p));
    for (const double gain : workspace.neighbourhood()) EXPECT_EQ(gain, 0.0);
  }
}

TEST(TMpsomLaws, TheSameBitsOnEveryInstructionSet) {
  for (const TMpsomParameters& p : variants()) {
    std::vector<float> expected;
    testing::for_each_instruction_set([&](InstructionSet set) {
      Random random(34);
      TMpsom map(p);
      std::vector<float> results;
      for (int step = 0; step < 10; ++step) {
        learn(map, random_inputs(random, p, Sign::kPositive), 0.4);
        const auto activity = activation(map, random_inputs(random, p, Sign::kPositive));
        results.insert(results.end(), activity.begin(), activity.end());
      }
      for (std::size_t a = 0; a < p.input_sizes.size(); ++a) {
        const Matrix<float> weights = map.weights(a);
        results.insert(results.end(), weights.values().begin(), weights.values().end());
      }
      if (expected.empty()) expected = results;
      EXPECT_EQ(results, expected) << name_of(set);
    });
  }
}

TEST(TMpsomLaws, SparseInputsGiveWhatDenseOnesGive) {
  Random random(35);
  for (const TMpsomParameters& p : variants()) {
    for (int i = 0; i < 10; ++i) {
      const auto inputs = random_inputs(random, p, Sign::kPositive);
      const TMpsom map(p);
      const auto sparse = activation(map, inputs);
      const auto full = activation(map, densified(inputs));
      EXPECT_EQ(sparse, full);
      TMpsom learned = map;
      TMpsom learned_full = map;
      learn(learned, inputs, 0.5);
      learn(learned_full, densified(inputs), 0.5);
      EXPECT_EQ(learned, learned_full);
    }
  }
}

TEST(TMpsomLaws, UsingAMapAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "a sanitizer brings its own operator new";
  Random random(36);
  for (const TMpsomParameters& p : variants()) {
    TMpsom map(p);
    TMpsom::Workspace workspace(map);
    std::vector<float> activity(map.neurons());
    const auto inputs = random_inputs(random, p, Sign::kPositive);
    const auto input_views = views(inputs);
    const testing::AllocationCounter counter;
    map.activation(input_views, workspace, activity);
    map.learn(input_views, 0.5, workspace);
    EXPECT_EQ(counter.count(), 0U);
  }
}

}  // namespace
}  // namespace somato
