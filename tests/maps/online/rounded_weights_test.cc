#include "maps/online/rounded_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/support/instruction_sets.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kRoundedLanes = LaneMatrix<float>::kLanes;

// Neurons with weights from almost nothing to very much, and one of zeros.
LaneMatrix<float> random_weights(Random& random) {
  LaneMatrix<float> weights(1 + random.below(40), 1 + random.below(200));
  for (std::size_t neuron = 1; neuron < weights.rows(); ++neuron) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 120);
    for (std::size_t d = 0; d < weights.columns(); ++d) {
      weights(neuron, d) = static_cast<float>(scale * random.normal());
    }
  }
  return weights;
}

double greatest_of(const LaneMatrix<float>& weights, std::size_t neuron) {
  double greatest = 0.0;
  for (std::size_t d = 0; d < weights.columns(); ++d) {
    greatest = std::max(greatest, std::fabs(double{weights(neuron, d)}));
  }
  return greatest;
}

// The difference between weights and their rounded values.
double difference(const LaneMatrix<float>& weights, const RoundedWeights& rounded,
                  std::size_t neuron) {
  double squares = 0.0;
  for (std::size_t d = 0; d < weights.columns(); ++d) {
    const std::int16_t integer =
        rounded.block(neuron / kRoundedLanes)[d * kRoundedLanes + neuron % kRoundedLanes];
    const double off = double{weights(neuron, d)} - rounded.step(neuron) * integer;
    squares += off * off;
  }
  return std::sqrt(squares);
}

// Writes in two tiles, as a learner does.
void round_all(RoundedWeights& rounded, const LaneMatrix<float>& weights) {
  const std::size_t half = weights.columns() / 2;
  for (std::size_t block = 0; block < weights.blocks(); ++block) {
    const float* from = weights.data() + block * weights.columns() * kRoundedLanes;
    rounded.begin(block);
    rounded.write(block, 0, half, from);
    rounded.write(block, half, weights.columns() - half, from + half * kRoundedLanes);
    rounded.end(block);
  }
}

TEST(RoundedWeights, AreWithinTheirError) {
  testing::for_each_instruction_set([](InstructionSet) {
    Random random(1);
    for (int i = 0; i < 100; ++i) {
      const LaneMatrix<float> weights = random_weights(random);
      RoundedWeights rounded(weights);
      // A loose bound costs accuracy and is forgotten afterwards.
      const double loose = 1.0 + 3.0 * random.uniform();
      for (std::size_t n = 0; n < weights.rows(); ++n) {
        EXPECT_GE(rounded.greatest(n), greatest_of(weights, n));
        rounded.set_greatest(n, loose * greatest_of(weights, n));
      }
      round_all(rounded, weights);
      for (std::size_t n = 0; n < weights.rows(); ++n) {
        const double greatest = greatest_of(weights, n);
        EXPECT_EQ(rounded.greatest(n), greatest);
        EXPECT_LE(difference(weights, rounded, n), rounded.error(n)) << n;
        const double expected = std::max(loose * greatest, 0x1p-90) / 65000.0 *
                                std::sqrt(static_cast<double>(weights.columns()));
        EXPECT_LE(rounded.error(n), 1.1 * expected);
      }
    }
  });
}

}  // namespace
}  // namespace somato
