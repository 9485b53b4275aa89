#include "maps/reading/screening_run.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

// Far apart clusters on a large map, whose samples come in no order; more than one run of them.
TEST(ScreeningRun, FindsTheWinnersOfARangeOfSamples) {
  constexpr std::size_t kSide = 24;
  Random random(1);
  Matrix<float> weights(kSide * kSide, 4);
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    weights(k, 0) = static_cast<float>(k % kSide);
    weights(k, 1) = static_cast<float>(k / kSide);
  }
  SomParameters parameters;
  parameters.rows = kSide;
  parameters.columns = kSide;
  const Som som(parameters, weights);
  Matrix<float> rows(1600, 4);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const std::size_t neuron = random.below(som.neurons());
    expected.push_back(neuron);
    rows(i, 0) = static_cast<float>(neuron % kSide) + 0.4F * static_cast<float>(random.uniform());
    rows(i, 1) = static_cast<float>(neuron / kSide) - 0.4F * static_cast<float>(random.uniform());
    rows(i, 2) = static_cast<float>(random.uniform());
  }
  const Samples samples(std::move(rows));
  const ScreenedMap map(som, 1);
  std::vector<Winners> found(samples.count() - 100);
  ScreeningRun(som, map, samples, false).find(100, found);
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i].first, expected[100 + i]) << i;
}

}  // namespace
}  // namespace somato
