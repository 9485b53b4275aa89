#include "somato/maps/som.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "maps/support/random_maps.h"
#include "maps/training/som_reference.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr double kEpsilon = std::numeric_limits<float>::epsilon();

Matrix<float> random_weights(std::size_t neurons, std::size_t size, bool length_one,
                             Random& random) {
  Matrix<float> weights(neurons, size);
  for (float& weight : weights.values()) weight = static_cast<float>(random.normal());
  for (std::size_t neuron = 0; length_one && neuron < neurons; ++neuron) {
    normalize_length(weights.row(neuron));
  }
  return weights;
}

Matrix<double> widened(const Matrix<float>& weights) {
  return {weights.rows(), weights.columns(), {weights.values().begin(), weights.values().end()}};
}

// How far a score in single precision may be from the exact one: one rounding a term and one for
// the input's normalization, relative to the sum of the terms' magnitudes.
double score_bound(const SomParameters& p, std::span<const double> input,
                   std::span<const double> weights) {
  double magnitude = follows_from_products(p.similarity) ? 0.0 : 2.0;
  for (std::size_t d = 0; d < input.size(); ++d) {
    if (!follows_from_products(p.similarity)) magnitude += 2.0 * std::fabs(input[d] - weights[d]);
    if (!follows_from_products(p.similarity)) continue;
    magnitude += p.similarity == Similarity::kEuclidean
                     ? (input[d] - weights[d]) * (input[d] - weights[d]) +
                           2.0 * std::fabs(input[d] * (input[d] - weights[d]))
                     : std::fabs(input[d] * weights[d]);
  }
  return (static_cast<double>(input.size()) + 4.0) * kEpsilon * magnitude;
}

TEST(Som, FindsTheWinnersOfTheReferenceOnTenThousandProblems) {
  Random random(41);
  const auto variants = testing::all_variants();
  int ambiguous = 0;
  for (int i = 0; i < 10000; ++i) {
    SomParameters p =
        testing::random_parameters(variants[static_cast<std::size_t>(i) % variants.size()], random);
    const std::size_t size = 1 + random.below(30);
    p = resolve(p, 1, size).value();
    const auto weights =
        random_weights(p.grid().size(), size, p.similarity == Similarity::kDotProduct, random);
    const Som som(p, weights);
    const ReferenceSom reference(p, widened(weights));
    const Samples samples = testing::random_samples(1, size, random.below(2) == 0, random);
    const std::vector<double> input = reference.inputs(samples)[0];
    SomWorkspace workspace;

    const std::size_t winner = som.winner(samples[0], workspace);
    const std::size_t expected = reference.winner(input);
    EXPECT_EQ(som.winners(samples[0], workspace).first, winner);
    if (winner == expected) continue;
    ++ambiguous;
    const double bound = score_bound(p, input, reference.weights().row(winner)) +
                         score_bound(p, input, reference.weights().row(expected));
    EXPECT_LE(std::fabs(reference.score(input, winner) - reference.score(input, expected)), bound);
  }
  EXPECT_LT(ambiguous, 10);
}

TEST(Som, FindsTheSecondWinnerAsTheWinnerAmongTheOthers) {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const auto variants = testing::all_variants();
    SomParameters p = testing::random_parameters(variants[random.below(variants.size())], random);
    p = resolve(p, 1, 5).value();
    const Som som(p, random_weights(p.grid().size(), 5, false, random));
    const Samples samples = testing::random_samples(1, 5, false, random);
    SomWorkspace workspace;
    const Winners winners = som.winners(samples[0], workspace);
    if (som.neurons() == 1) {
      EXPECT_EQ(winners.second, winners.first);
      continue;
    }
    std::vector<std::size_t> others(som.neurons());
    std::iota(others.begin(), others.end(), std::size_t{0});
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(winners.first));
    EXPECT_EQ(winners.second, som.winner_among(others, samples[0], workspace));
  }
}

TEST(Som, GivesTiesToTheFirstNeuron) {
  SomParameters p;
  p.rows = 1;
  p.columns = 40;
  const Som som(resolve(p, 1, 1).value(), Matrix<float>(40, 1, 2.0F));
  SomWorkspace workspace;
  const std::vector<float> input{1.0F};
  EXPECT_EQ(som.winner(SignalView::dense(input), workspace), 0U);
  EXPECT_EQ(som.winners(SignalView::dense(input), workspace).second, 1U);
}

TEST(Som, HasTheActivityOfTheReference) {
  Random random(43);
  for (int i = 0; i < 2000; ++i) {
    const auto variants = testing::all_variants();
    SomParameters p = testing::random_parameters(variants[random.below(variants.size())], random);
    p.softmax = random.below(2) == 0 ? Softmax::kPower : Softmax::kExponential;
    p.activity_norm = random.below(2) == 0 ? ActivityNorm::kSum : ActivityNorm::kMaximum;
    p.softmax_exponent = static_cast<double>(1 + random.below(12));
    p = resolve(p, 1, 6).value();
    const auto weights = random_weights(p.grid().size(), 6, true, random);
    const Samples samples = testing::random_samples(1, 6, random.below(2) == 0, random);
    const ReferenceSom reference(p, widened(weights));
    const std::vector<double> expected = reference.activity(reference.inputs(samples)[0]);
    const Som som(p, weights);
    SomWorkspace workspace;
    std::vector<float> activity(som.neurons());
    som.activity(samples[0], workspace, activity);
    for (std::size_t neuron = 0; neuron < activity.size(); ++neuron) {
      EXPECT_NEAR(activity[neuron], expected[neuron], 2e-5) << "exponent " << p.softmax_exponent;
    }
  }
}

TEST(Som, OfAZeroInputHasNoActivity) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  p.similarity = Similarity::kDotProduct;
  const Som som(resolve(p, 1, 2).value(), Matrix<float>(2, 2, {1, 0, 0, 1}));
  SomWorkspace workspace;
  std::vector<float> activity(2, 9.0F);
  som.activity(Signal::sparse({2}, {}, {}).view(), workspace, activity);
  EXPECT_EQ(activity, (std::vector<float>{0, 0}));
}

TEST(Som, AnswersTheSameToSparseAndDenseInputs) {
  Random random(44);
  SomParameters p;
  p.rows = p.columns = 15;
  p = resolve(p, 1, 50).value();
  const Som som(p, random_weights(225, 50, false, random));
  for (int i = 0; i < 100; ++i) {
    const Samples sparse = testing::random_samples(1, 50, true, random);
    std::vector<float> values(50);
    write_dense(sparse[0], values);
    SomWorkspace workspace;
    const SignalView dense = SignalView::dense(values);
    EXPECT_EQ(som.winner(sparse[0], workspace), som.winner(dense, workspace));
    EXPECT_EQ(som.distance(sparse[0], 7, workspace), som.distance(dense, 7, workspace));
  }
}

TEST(Som, RefusesInputsOfAnotherSize) {
  const Som som(resolve({}, 1, 2).value(), Matrix<float>(9, 2));
  SomWorkspace workspace;
  const std::vector<float> input(3);
  EXPECT_THROW((void)som.winner(SignalView::dense(input), workspace), InvalidArgument);
  EXPECT_THROW(Som(resolve({}, 1, 2).value(), Matrix<float>(3, 2)), InvalidArgument);
}

TEST(NormalizeLength, KeepsZeros) {
  std::vector<float> zeros(3);
  normalize_length(zeros);
  EXPECT_EQ(zeros, (std::vector<float>{0, 0, 0}));
  std::vector<float> values{3, 4};
  normalize_length(values);
  EXPECT_FLOAT_EQ(values[0], 0.6F);
  EXPECT_FLOAT_EQ(values[1], 0.8F);
}

}  // namespace
}  // namespace somato
