// Training on samples with missing elements, against the equations in plain loops.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/som_comparison.h"
#include "maps/training/som_reference.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr Similarity kBySums[] = {Similarity::kEuclidean, Similarity::kManhattan,
                                  Similarity::kChebyshev};

struct IncompleteProblem {
  SomParameters parameters;
  Matrix<float> incomplete;
  Samples filled;
};

// Each sample knows at least one element, and each element is known of a sample.
IncompleteProblem incomplete_problem(Similarity similarity, Training training, Random& random) {
  const std::size_t size = 1 + random.below(12);
  const std::size_t count = size + random.below(20);
  Matrix<float> incomplete(count, size);
  Matrix<float> filled(count, size);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t d = 0; d < size; ++d) {
      filled(i, d) = static_cast<float>(random.normal());
      const bool known = d == i % size || random.below(3) != 0;
      incomplete(i, d) = known ? filled(i, d) : kUnknown;
    }
  }
  SomParameters p;
  p.rows = 1 + random.below(5);
  p.columns = 1 + random.below(5);
  p.similarity = similarity;
  p.training = training;
  p.neighbourhood =
      random.below(2) == 0 ? NeighbourhoodShape::kGaussian : NeighbourhoodShape::kBubble;
  p.iterations = 60;
  p.epochs = 3;
  p.seed = random.next();
  return {resolve(p, count, size).value(), std::move(incomplete), Samples(std::move(filled))};
}

double known_distance(Similarity similarity, std::span<const float> x,
                      std::span<const double> weights) {
  double sum = 0.0;
  double most = 0.0;
  for (std::size_t d = 0; d < x.size(); ++d) {
    if (std::isnan(x[d])) continue;
    const double apart = std::fabs(double{x[d]} - weights[d]);
    sum += similarity == Similarity::kManhattan ? apart : apart * apart;
    most = std::max(most, apart);
  }
  return similarity == Similarity::kChebyshev ? most : sum;
}

// The winner, or nothing if rounding may decide.
std::optional<std::size_t> known_winner(Similarity similarity, std::span<const float> x,
                                        const Matrix<double>& weights) {
  std::size_t best = 0;
  for (std::size_t n = 1; n < weights.rows(); ++n) {
    const double least = known_distance(similarity, x, weights.row(best));
    if (known_distance(similarity, x, weights.row(n)) < least) best = n;
  }
  const double least = known_distance(similarity, x, weights.row(best));
  for (std::size_t n = 0; n < weights.rows(); ++n) {
    if (n == best) continue;
    if (known_distance(similarity, x, weights.row(n)) < least + 1e-5 * (1.0 + least)) return {};
  }
  return best;
}

// The weights after the whole training, or nothing.
std::optional<Matrix<double>> trained_by_hand(const IncompleteProblem& problem) {
  const SomParameters& p = problem.parameters;
  Matrix<double> weights = ReferenceSom::initial(p, problem.filled).weights();
  const ReferenceSom grid(p, weights);
  DrawSequence draws(p.draws, problem.incomplete.rows(), p.seed);
  for (std::uint64_t step = 0; step < p.steps(); ++step) {
    const double radius = p.radius().at(step);
    if (p.training == Training::kOnline) {
      const auto x = problem.incomplete.row(draws.next());
      const auto winner = known_winner(p.similarity, x, weights);
      if (!winner) return {};
      for (std::size_t n = 0; n < weights.rows(); ++n) {
        const double gain = p.learning_rate().at(step) * grid.neighbourhood(*winner, n, radius);
        for (std::size_t d = 0; d < x.size(); ++d) {
          if (!std::isnan(x[d])) weights(n, d) += gain * (x[d] - weights(n, d));
        }
      }
      continue;
    }
    Matrix<double> sums(weights.rows(), weights.columns());
    Matrix<double> totals(weights.rows(), weights.columns());
    for (std::size_t i = 0; i < problem.incomplete.rows(); ++i) {
      const auto x = problem.incomplete.row(i);
      const auto winner = known_winner(p.similarity, x, weights);
      if (!winner) return {};
      for (std::size_t n = 0; n < weights.rows(); ++n) {
        for (std::size_t d = 0; d < x.size(); ++d) {
          if (std::isnan(x[d])) continue;
          sums(n, d) += grid.neighbourhood(*winner, n, radius) * x[d];
          totals(n, d) += grid.neighbourhood(*winner, n, radius);
        }
      }
    }
    for (std::size_t n = 0; n < weights.rows(); ++n) {
      for (std::size_t d = 0; d < weights.columns(); ++d) {
        if (totals(n, d) > 0.0) weights(n, d) = sums(n, d) / totals(n, d);
      }
    }
  }
  return weights;
}

TEST(IncompleteTrainingThreads, FollowsTheEquationsOverKnownElements) {
  Random random(1);
  int compared = 0;
  for (int i = 0; i < 240; ++i) {
    const Similarity similarity = kBySums[i % 3];
    const auto problem =
        incomplete_problem(similarity, i % 2 == 0 ? Training::kOnline : Training::kBatch, random);
    const auto expected = trained_by_hand(problem);
    if (!expected) continue;
    const Samples incomplete(problem.incomplete);
    TrainingOptions options;
    options.incomplete = &incomplete;
    const Som som = train_som(problem.parameters, problem.filled, options).value();
    for (std::size_t n = 0; n < som.neurons(); ++n) {
      for (std::size_t d = 0; d < som.input_size(); ++d) {
        ASSERT_NEAR(som.weight(n, d), (*expected)(n, d), 1e-4) << choice_name(similarity);
      }
    }
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      options.threads = 3;
      EXPECT_EQ(train_som(problem.parameters, problem.filled, options)->weights(), som.weights());
    });
    ++compared;
  }
  EXPECT_GT(compared, 120);
}

// Law: with all elements known it is plain training, to the bit where that makes the same passes.
TEST(IncompleteTraining, OfCompleteSamplesIsPlainTraining) {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const Training training = i % 2 == 0 ? Training::kOnline : Training::kBatch;
    const auto problem = incomplete_problem(kBySums[i % 3], training, random);
    TrainingOptions options;
    options.incomplete = &problem.filled;
    SomParameters p = problem.parameters;
    p.arithmetic = Arithmetic::kPlain;
    const Som known = train_som(p, problem.filled, options).value();
    const Som plain = train_som(p, problem.filled).value();
    const bool same_passes = training == Training::kBatch || p.similarity != Similarity::kEuclidean;
    if (same_passes) {
      EXPECT_EQ(known.weights(), plain.weights());
    }
  }
}

TEST(IncompleteTraining, RefusesMapsThatCompareDirections) {
  const Samples samples(Matrix<float>(3, 2, {1, 2, 3, 4, 5, 6}));
  TrainingOptions options;
  options.incomplete = &samples;
  for (const Similarity similarity : {Similarity::kDotProduct, Similarity::kCosine}) {
    SomParameters p;
    p.similarity = similarity;
    EXPECT_EQ(train_som(p, samples, options).error().kind, ErrorKind::kUsage);
  }
  SomParameters p;
  p.normalize_input = true;
  EXPECT_EQ(train_som(p, samples, options).error().kind, ErrorKind::kUsage);
  p = {};
  p.arithmetic = Arithmetic::kInnerProducts;
  EXPECT_EQ(train_som(p, samples, options).error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
