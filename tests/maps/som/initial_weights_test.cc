#include "maps/som/initial_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

SomParameters parameters_with(InitialWeights initial_weights) {
  SomParameters p;
  p.rows = 20;
  p.columns = 20;
  p.initial_weights = initial_weights;
  return p;
}

std::vector<float> weights_of(const InitialWeightsSource& source, std::size_t neuron,
                              std::size_t size) {
  std::vector<float> weights(size);
  source.write(neuron, weights);
  return weights;
}

TEST(InitialWeights, UniformOnesFillTheUnitInterval) {
  const Samples samples(Matrix<float>(1, 50));
  const InitialWeightsSource source(parameters_with(InitialWeights::kUniform), samples);
  double sum = 0.0;
  double least = 1.0;
  double greatest = 0.0;
  for (std::size_t neuron = 0; neuron < 400; ++neuron) {
    for (const float weight : weights_of(source, neuron, 50)) {
      sum += weight;
      least = std::min(least, double{weight});
      greatest = std::max(greatest, double{weight});
    }
  }
  // 20000 values: the mean's standard deviation is 1/sqrt(12 * 20000) = 0.002.
  EXPECT_NEAR(sum / 20000.0, 0.5, 0.01);
  EXPECT_GE(least, 0.0);
  EXPECT_LT(least, 0.001);
  EXPECT_GT(greatest, 0.999);
  EXPECT_LT(greatest, 1.0);
}

TEST(InitialWeights, RangeStaysBetweenTheLeastAndTheGreatestOfEachFeature) {
  const Samples samples(Matrix<float>(3, 2, {-5, 100, -4, 300, -3, 200}));
  const InitialWeightsSource source(parameters_with(InitialWeights::kRange), samples);
  for (std::size_t neuron = 0; neuron < 400; ++neuron) {
    const auto weights = weights_of(source, neuron, 2);
    EXPECT_TRUE(weights[0] >= -5.0F && weights[0] <= -3.0F);
    EXPECT_TRUE(weights[1] >= 100.0F && weights[1] <= 300.0F);
  }
}

TEST(InitialWeights, RangeCountsTheZerosOfSparseSamples) {
  const Samples samples = Samples::from_signals(
      {Signal::sparse({2}, {0}, {4.0F}), Signal::sparse({2}, {0, 1}, {2.0F, 1.0F})});
  const InitialWeightsSource source(parameters_with(InitialWeights::kRange), samples);
  float least = 1.0F;
  for (std::size_t neuron = 0; neuron < 400; ++neuron) {
    const auto weights = weights_of(source, neuron, 2);
    EXPECT_TRUE(weights[0] >= 2.0F && weights[0] <= 4.0F);
    least = std::min(least, weights[1]);
  }
  EXPECT_LT(least, 0.05F);
}

TEST(InitialWeights, SamplesAreDrawnWithoutRepeatsWhileThereAreEnough) {
  Random random(31);
  const Samples samples = testing::random_samples(400, 3, false, random);
  const InitialWeightsSource source(parameters_with(InitialWeights::kSamples), samples);
  std::set<std::size_t> drawn;
  for (std::size_t neuron = 0; neuron < 400; ++neuron) {
    drawn.insert(source.sample_of(neuron));
    const auto sample = samples[source.sample_of(neuron)].values;
    EXPECT_EQ(weights_of(source, neuron, 3), std::vector<float>(sample.begin(), sample.end()));
  }
  EXPECT_EQ(drawn.size(), 400U);
}

TEST(InitialWeights, HaveLengthOneForADotProductMap) {
  const Samples samples(Matrix<float>(1, 9));
  SomParameters p = parameters_with(InitialWeights::kUniform);
  p.similarity = Similarity::kDotProduct;
  const InitialWeightsSource source(p, samples);
  double square = 0.0;
  for (const float weight : weights_of(source, 3, 9)) square += double{weight} * double{weight};
  EXPECT_NEAR(square, 1.0, 1e-6);
}

TEST(InitialWeights, DifferBetweenSeedsAndNeurons) {
  const Samples samples(Matrix<float>(1, 9));
  SomParameters p = parameters_with(InitialWeights::kUniform);
  const auto first = weights_of(InitialWeightsSource(p, samples), 0, 9);
  EXPECT_NE(first, weights_of(InitialWeightsSource(p, samples), 1, 9));
  EXPECT_EQ(first, weights_of(InitialWeightsSource(p, samples), 0, 9));
  p.seed = 2;
  EXPECT_NE(first, weights_of(InitialWeightsSource(p, samples), 0, 9));
}

// The plane's centre is the mean, and its corners are a standard deviation away along each
// component; the seed has no effect.
TEST(InitialWeights, LinearOnesLieOnThePlane) {
  const Samples samples(Matrix<float>(4, 2, {8, 5, 2, 5, 5, 6, 5, 4}));
  SomParameters p = parameters_with(InitialWeights::kLinear);
  p.rows = 3;
  p.columns = 5;
  const auto first = static_cast<float>(std::sqrt(4.5));
  const auto second = static_cast<float>(std::sqrt(0.5));
  for (const std::uint64_t seed : {1U, 2U}) {
    p.seed = seed;
    const InitialWeightsSource source(p, samples);
    const auto expect_weights = [&](std::size_t neuron, float x, float y) {
      const std::vector<float> weights = weights_of(source, neuron, 2);
      EXPECT_NEAR(weights[0], x, 1e-5);
      EXPECT_NEAR(weights[1], y, 1e-5);
    };
    expect_weights(7, 5, 5);
    expect_weights(0, 5 - first, 5 - second);
    expect_weights(14, 5 + first, 5 + second);
    expect_weights(8, 5 + first / 2, 5);
  }
}

TEST(InitialWeights, LinearOnesHaveLengthOneForADotProductMap) {
  Random random(4);
  SomParameters p = parameters_with(InitialWeights::kLinear);
  p.similarity = Similarity::kDotProduct;
  const Samples samples = testing::random_samples(20, 6, false, random);
  const InitialWeightsSource source(p, samples);
  for (std::size_t neuron = 0; neuron < p.grid().size(); ++neuron) {
    double square = 0.0;
    for (const float weight : weights_of(source, neuron, 6)) square += double{weight} * weight;
    EXPECT_NEAR(square, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace somato
