#include "maps/training/batch_training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/grid/feature_ranges.h"
#include "maps/reading/winner_search.h"
#include "maps/som/initial_weights.h"
#include "maps/support/random_maps.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Samples noise(std::size_t count, std::size_t size, std::uint64_t seed) {
  Random random(seed);
  Matrix<float> rows(count, size);
  for (float& value : rows.values()) value = static_cast<float>(random.uniform());
  return Samples(std::move(rows));
}

Som untrained(const testing::Variant& variant, const Samples& samples) {
  Random random(3);
  SomParameters parameters = testing::random_parameters(variant, random);
  parameters.rows = 8;
  parameters.columns = 7;
  return untrained_som(parameters, samples).value();
}

SumScales scales_of(const Samples& seen) {
  std::vector<float> low;
  std::vector<float> high;
  widen_ranges(seen, low, high);
  return {seen.count(), low, high};
}

std::vector<std::size_t> range(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> indices;
  for (std::size_t i = begin; i < end; ++i) indices.push_back(i);
  return indices;
}

TEST(BatchTrainingThreads, IsTheSameBitsHoweverSamplesArePartedAndOnEveryInstructionSet) {
  const Samples samples = noise(300, 21, 1);
  for (const testing::Variant& variant : testing::variants_in_pairs()) {
    const Som start = untrained(variant, samples);
    Som whole = start;
    const auto winners = batch_epoch(whole, samples, 2.0, 1);
    Samples storage;
    const Samples& seen = seen_samples(start, samples, storage);
    const SumScales scales = scales_of(seen);
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      for (const std::size_t threads : {1U, 2U, 4U}) {
        Som parted = start;
        BatchEpoch epoch(parted, scales, threads);
        std::vector<std::size_t> found;
        for (const auto& [begin, end] : {std::pair{0, 3}, {3, 170}, {170, 300}}) {
          const auto some = epoch.add(
              seen.subset(range(static_cast<std::size_t>(begin), static_cast<std::size_t>(end))));
          found.insert(found.end(), some.begin(), some.end());
        }
        epoch.finish(2.0);
        ASSERT_EQ(found, winners) << testing::name_of(variant);
        ASSERT_TRUE(parted.weights() == whole.weights()) << testing::name_of(variant);
      }
    });
  }
}

// Two winners far apart, and a radius at which the neurons between them are reached by nothing.
TEST(BatchTraining, ANeuronThatNoWinnerReachesKeepsItsWeights) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 90;
  Matrix<float> weights(90, 1, 5.0F);
  weights(0, 0) = 0.0F;
  weights(89, 0) = 10.0F;
  Som som(parameters, weights);
  Matrix<float> rows(2, 1);
  rows(0, 0) = 1.0F;
  rows(1, 0) = 9.0F;
  batch_epoch(som, Samples(std::move(rows)), 1.0, 1);
  EXPECT_EQ(som.weights()(0, 0), 1.0F);
  EXPECT_EQ(som.weights()(30, 0), 1.0F);  // exp(-30^2 / 2) is above 2^-1000
  EXPECT_EQ(som.weights()(38, 0), 5.0F);  // exp(-38^2 / 2) is not
  EXPECT_EQ(som.weights()(60, 0), 9.0F);
  EXPECT_EQ(som.weights()(89, 0), 9.0F);
}

}  // namespace
}  // namespace somato
