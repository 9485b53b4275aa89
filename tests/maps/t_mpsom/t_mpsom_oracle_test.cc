#include "somato/maps/t_mpsom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/support/sanitized.h"
#include "maps/support/t_mpsom_problems.h"
#include "maps/t_mpsom/t_mpsom_reference.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// TMpsom against TMpsomReference, which is slow and obvious, on random problems.

using testing::activation;
using testing::learn;
using testing::random_inputs;
using testing::random_parameters;
using testing::random_weights;
using testing::Sign;
using testing::views;

// What "within 1e-5" is relative to: see each comparison.
constexpr double kTolerance = 1e-5;

struct OracleProblem {
  TMpsomParameters parameters;
  std::vector<Matrix<float>> weights;
  std::vector<Signal> inputs;
  double alpha = 0.0;
};

OracleProblem random_problem(Random& random) {
  const Sign sign = random.below(2) ? Sign::kPositive : Sign::kEither;
  OracleProblem problem{random_parameters(random), {}, {}, random.uniform()};
  problem.weights = random_weights(random, problem.parameters, sign);
  problem.inputs = random_inputs(random, problem.parameters, sign);
  return problem;
}

TMpsom fast_map(const OracleProblem& problem) {
  Result<TMpsom> map = TMpsom::from_weights(problem.parameters, problem.weights);
  EXPECT_TRUE(map);
  return std::move(*map);
}

using Change = double (*)(double);
double keep(double value) {
  return value;
}

TMpsomReference reference_map(const OracleProblem& problem, Change change = keep) {
  std::vector<Matrix<double>> weights;
  for (const Matrix<float>& matrix : problem.weights) {
    Matrix<double>& copy = weights.emplace_back(matrix.rows(), matrix.columns());
    std::transform(matrix.values().begin(), matrix.values().end(), copy.values().begin(), change);
  }
  return {problem.parameters, std::move(weights)};
}

std::vector<std::vector<double>> reference_inputs(const OracleProblem& problem,
                                                  Change change = keep) {
  std::vector<std::vector<double>> inputs;
  for (const Signal& signal : problem.inputs) {
    const std::vector<float> values = signal.to_dense();
    std::transform(values.begin(), values.end(), inputs.emplace_back(values.size()).begin(),
                   change);
  }
  return inputs;
}

// y with all weights and inputs made positive: terms of different sign may cancel, and rounding is
// relative to this. Arbors and weights below 1e-18 are taken as zero, so a little of the same with
// endless arbors is added.
std::vector<double> magnitudes(OracleProblem problem) {
  const Change magnitude = [](double value) { return std::fabs(value); };
  const auto inputs = reference_inputs(problem, magnitude);
  std::vector<double> sum = reference_map(problem, magnitude).activation(inputs);
  problem.parameters.arbor_sigma = 1e6;
  const auto endless = reference_map(problem, magnitude).activation(inputs);
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += 1e-11 * endless[n];
  return sum;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

// How much cancelling magnifies rounding in N, at least 1; infinite without activity.
double conditioning(const std::vector<double>& activity, const std::vector<double>& magnitude) {
  const double total = std::accumulate(magnitude.begin(), magnitude.end(), 0.0);
  const double best = std::max(largest(activity), 0.0);
  return std::max(1.0, total / best);
}

void compare_activation(const OracleProblem& problem) {
  const std::vector<float> fast = activation(fast_map(problem), problem.inputs);
  const auto slow = reference_map(problem).activation(reference_inputs(problem));
  const std::vector<double> magnitude = magnitudes(problem);
  for (std::size_t n = 0; n < slow.size(); ++n) {
    EXPECT_NEAR(double{fast[n]}, slow[n], kTolerance * magnitude[n]) << "neuron " << n;
  }
  const double rounding = 2.0 * kTolerance * largest(magnitude);
  EXPECT_GE(slow[TMpsom::winner(fast)], largest(slow) - rounding);
}

// The length of a moved weight vector before it is normalized: what divides it magnifies rounding.
double moved_length(std::span<const float> weights, std::span<const double> sample, double gain) {
  double squares = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double moved = weights[k] + gain * (sample[k] - weights[k]);
    squares += moved * moved;
  }
  return std::sqrt(squares);
}

std::vector<double> unit_sample(const TMpsomParameters& p, std::vector<double> sample) {
  const double squares = std::inner_product(sample.begin(), sample.end(), sample.begin(), 0.0);
  if (p.input_norm == TMpsomNorm::kNone || squares == 0.0) return sample;
  for (double& value : sample) value /= std::sqrt(squares);
  return sample;
}

// One step from the same state; false when cancelling leaves nothing to compare.
bool compare_step(const OracleProblem& problem) {
  TMpsom fast = fast_map(problem);
  TMpsomReference slow = reference_map(problem);
  const auto inputs = reference_inputs(problem);
  const std::vector<double> activity = slow.activation(inputs);
  const std::vector<double> magnitude = magnitudes(problem);
  if (largest(magnitude) == 0.0) {
    EXPECT_FALSE(learn(fast, problem.inputs, problem.alpha));
    EXPECT_FALSE(slow.learn(inputs, problem.alpha));
    EXPECT_EQ(fast, fast_map(problem));
    return true;
  }
  const double condition = conditioning(activity, magnitude);
  const bool all_negative = largest(activity) <= 0.0;
  if (all_negative || condition > 1e4) return false;

  TMpsom::Workspace workspace(fast);
  EXPECT_TRUE(fast.learn(views(problem.inputs), problem.alpha, workspace));
  EXPECT_TRUE(slow.learn(inputs, problem.alpha));
  const std::vector<double> gains = slow.neighbourhood(activity);
  for (std::size_t n = 0; n < gains.size(); ++n) {
    EXPECT_NEAR(workspace.neighbourhood()[n], gains[n], kTolerance * condition);
  }
  const TMpsomParameters& p = problem.parameters;
  for (std::size_t a = 0; a < inputs.size(); ++a) {
    const std::vector<double> sample = unit_sample(p, inputs[a]);
    const Matrix<float> moved = fast.weights(a);
    for (std::size_t n = 0; n < moved.rows(); ++n) {
      const auto before = problem.weights[a].row(n);
      const double scale =
          moved_length(before, sample, 0.0) +
          std::sqrt(std::inner_product(sample.begin(), sample.end(), sample.begin(), 0.0));
      const double after = moved_length(before, sample, problem.alpha * gains[n]);
      const double divisor = p.weight_norm == TMpsomNorm::kL2 ? after : 1.0;
      if (divisor == 0.0) continue;
      for (std::size_t k = 0; k < moved.columns(); ++k) {
        EXPECT_NEAR(double{moved(n, k)}, slow.weights(a)(n, k),
                    kTolerance * condition * scale / divisor)
            << "input " << a << ", neuron " << n;
      }
    }
  }
  return true;
}

TEST(TMpsom, AgreesWithTheReferenceOnRandomProblems) {
  constexpr int kProblems = testing::fewer_if_sanitized(4000);
  Random random(21);
  int compared = 0;
  for (int i = 0; i < kProblems; ++i) {
    const OracleProblem problem = random_problem(random);
    compare_activation(problem);
    compared += compare_step(problem) ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << "problem " << i << "\n" << parameters_to_toml(problem.parameters);
  }
  EXPECT_GT(compared, kProblems * 8 / 10);
}

TEST(TMpsom, StartsFromTheWeightsOfTheReference) {
  Random random(22);
  for (int i = 0; i < 50; ++i) {
    const TMpsomParameters p = random_parameters(random);
    const TMpsom fast(p);
    const TMpsomReference slow(p);
    for (std::size_t a = 0; a < p.input_sizes.size(); ++a) {
      const auto expected = slow.weights(a).values();
      const Matrix<float> weights = fast.weights(a);
      ASSERT_EQ(weights.values().size(), expected.size());
      for (std::size_t place = 0; place < expected.size(); ++place) {
        EXPECT_NEAR(double{weights.values()[place]}, expected[place], 3e-7);
      }
    }
  }
}

}  // namespace
}  // namespace somato
