#include "somato/maps/t_mpsom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/t_mpsom_reference.h"
#include "support/instruction_sets.h"
#include "support/no_malloc.h"
#include "support/t_mpsom_by_hand.h"

namespace somato {
namespace {

using testing::ByHand;

// What "within 1e-5" is relative to: see each comparison.
constexpr double kTolerance = 1e-5;

std::vector<SignalView> views(const std::vector<Signal>& signals) {
  std::vector<SignalView> views;
  for (const Signal& signal : signals) views.push_back(signal.view());
  return views;
}

std::vector<Signal> dense(const std::vector<std::vector<float>>& inputs) {
  std::vector<Signal> signals;
  for (const auto& values : inputs) signals.push_back(Signal::dense(values));
  return signals;
}

std::vector<Signal> densified(const std::vector<Signal>& signals) {
  std::vector<Signal> all;
  for (const Signal& signal : signals) all.push_back(Signal::dense(signal.to_dense()));
  return all;
}

std::vector<float> activation(const TMpsom& map, const std::vector<Signal>& inputs) {
  TMpsom::Workspace workspace(map);
  std::vector<float> activity(map.neurons());
  map.activation(views(inputs), workspace, activity);
  return activity;
}

bool learn(TMpsom& map, const std::vector<Signal>& inputs, double alpha) {
  TMpsom::Workspace workspace(map);
  return map.learn(views(inputs), alpha, workspace);
}

double length(std::span<const float> values) {
  double squares = 0.0;
  for (const float value : values) squares += double{value} * double{value};
  return std::sqrt(squares);
}

double cosine(std::span<const float> a, std::span<const float> b) {
  double product = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) product += double{a[i]} * double{b[i]};
  return product / (length(a) * length(b));
}

// --- Random problems ---------------------------------------------------------------------------

enum class Sign { kPositive, kEither };

TMpsomParameters random_parameters(Random& random) {
  TMpsomParameters p;
  const std::size_t inputs = 1 + random.below(4);
  const std::size_t axes = 1 + random.below(inputs);
  for (std::size_t axis = 0; axis < axes; ++axis) p.shape.push_back(1 + random.below(6));
  for (std::size_t a = 0; a < inputs; ++a) {
    p.input_sizes.push_back(1 + random.below(9));
    p.input_axes.push_back(a < axes ? a : random.below(axes));
  }
  p.combination = random.below(2) ? TMpsomCombination::kMultiplied : TMpsomCombination::kAdded;
  p.arbor_sigma = 0.5 + 2.0 * random.uniform();
  p.neighbourhood_sigma = 1.0 + 2.0 * random.uniform();
  p.input_norm = random.below(3) ? TMpsomNorm::kL2 : TMpsomNorm::kNone;
  p.weight_norm = random.below(3) ? TMpsomNorm::kL2 : TMpsomNorm::kNone;
  p.seed = random.below(1000);
  return p;
}

float random_value(Random& random, Sign sign) {
  return static_cast<float>(sign == Sign::kEither ? random.normal() : random.uniform());
}

Signal random_signal(Random& random, std::size_t size, Sign sign) {
  std::vector<float> values(size);
  std::vector<std::uint32_t> indices;
  std::vector<float> stored;
  const bool is_zero = random.below(20) == 0;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (is_zero || random.below(3) == 0) continue;
    values[k] = random_value(random, sign);
    indices.push_back(k);
    stored.push_back(values[k]);
  }
  if (random.below(2)) return Signal::dense(values);
  return Signal::sparse({size}, indices, stored);
}

std::vector<Signal> random_inputs(Random& random, const TMpsomParameters& p, Sign sign) {
  std::vector<Signal> inputs;
  for (const std::size_t size : p.input_sizes) inputs.push_back(random_signal(random, size, sign));
  return inputs;
}

void scale_to_unit_length(std::span<float> values) {
  const double norm = length(values);
  if (norm == 0.0) return;
  for (float& value : values) value = static_cast<float>(value / norm);
}

std::vector<Matrix<float>> random_weights(Random& random, const TMpsomParameters& p, Sign sign) {
  std::vector<Matrix<float>> all;
  for (const std::size_t size : p.input_sizes) {
    Matrix<float>& weights = all.emplace_back(p.neurons(), size);
    for (std::size_t n = 0; n < weights.rows(); ++n) {
      if (random.below(30) == 0) continue;  // a row of zeros
      for (float& weight : weights.row(n)) weight = random_value(random, sign);
      if (p.weight_norm == TMpsomNorm::kL2) scale_to_unit_length(weights.row(n));
    }
  }
  return all;
}

struct Problem {
  TMpsomParameters parameters;
  std::vector<Matrix<float>> weights;
  std::vector<Signal> inputs;
  double alpha = 0.0;
};

Problem random_problem(Random& random) {
  const Sign sign = random.below(2) ? Sign::kPositive : Sign::kEither;
  Problem problem{random_parameters(random), {}, {}, random.uniform()};
  problem.weights = random_weights(random, problem.parameters, sign);
  problem.inputs = random_inputs(random, problem.parameters, sign);
  return problem;
}

TMpsom fast_map(const Problem& problem) {
  Result<TMpsom> map = TMpsom::from_weights(problem.parameters, problem.weights);
  EXPECT_TRUE(map);
  return std::move(*map);
}

// --- The same in double precision --------------------------------------------------------------

using Change = double (*)(double);
double keep(double value) {
  return value;
}

TMpsomReference reference_map(const Problem& problem, Change change = keep) {
  std::vector<Matrix<double>> weights;
  for (const Matrix<float>& matrix : problem.weights) {
    Matrix<double>& copy = weights.emplace_back(matrix.rows(), matrix.columns());
    std::transform(matrix.values().begin(), matrix.values().end(), copy.values().begin(), change);
  }
  return {problem.parameters, std::move(weights)};
}

std::vector<std::vector<double>> reference_inputs(const Problem& problem, Change change = keep) {
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
std::vector<double> magnitudes(Problem problem) {
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

// --- By hand -----------------------------------------------------------------------------------

template <typename Values>
void expect_near(const Values& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(double{values[i]}, expected[i], 3e-7) << i;
  }
}

TEST(TMpsom, IsRightByHand) {
  const auto inputs = dense(ByHand::inputs<float>());
  auto map = TMpsom::from_weights(ByHand::parameters(TMpsomCombination::kMultiplied),
                                  ByHand::weights<float>());
  ASSERT_TRUE(map);
  expect_near(activation(*map, inputs), ByHand::multiplied_activity());
  TMpsom::Workspace workspace(*map);
  EXPECT_TRUE(map->learn(views(inputs), ByHand::kAlpha, workspace));
  expect_near(workspace.neighbourhood(), ByHand::multiplied_neighbourhood());
  const Matrix<float> first = map->weights(0);
  const Matrix<float> second = map->weights(1);
  expect_near(first.values(), ByHand::multiplied_weights()[0]);
  expect_near(second.values(), ByHand::multiplied_weights()[1]);
}

TEST(TMpsom, IsRightByHandWhenAdded) {
  auto map =
      TMpsom::from_weights(ByHand::parameters(TMpsomCombination::kAdded), ByHand::weights<float>());
  ASSERT_TRUE(map);
  const auto inputs = dense(ByHand::inputs<float>());
  TMpsom::Workspace workspace(*map);
  EXPECT_TRUE(map->learn(views(inputs), ByHand::kAlpha, workspace));
  expect_near(workspace.activity(), ByHand::added_activity());
  expect_near(workspace.neighbourhood(), ByHand::added_neighbourhood());
}

// As in the reference's test: from 0 the first neuron would look at element 1, not 2.
TEST(TMpsom, CountsIndicesFromOne) {
  TMpsomParameters parameters;
  parameters.shape = {2};
  parameters.input_sizes = {4};
  parameters.arbor_sigma = 0.5;
  const Matrix<float> arbor = TMpsom(parameters).arbor(0);
  const double half = std::exp(-0.5);  // distance 0.5, sigma 0.5
  const double one = std::exp(-2.0);   // distance 1
  const double far = std::exp(-4.5);   // distance 1.5
  expect_near(arbor.values(), {half, 1.0, half, one, far, one, half, 1.0});
}

// --- Against the reference ---------------------------------------------------------------------

void compare_activation(const Problem& problem) {
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
bool compare_step(const Problem& problem) {
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
  constexpr int kProblems = 4000;
  Random random(21);
  int compared = 0;
  for (int i = 0; i < kProblems; ++i) {
    const Problem problem = random_problem(random);
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
      expect_near(fast.weights(a).values(), std::vector(expected.begin(), expected.end()));
    }
  }
}

// --- Laws of every variant ---------------------------------------------------------------------

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
      EXPECT_EQ(results, expected) << choice_name(set);
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
      const bool is_long = *std::max_element(p.input_sizes.begin(), p.input_sizes.end()) > 256;
      for (std::size_t n = 0; n < full.size(); ++n) {
        EXPECT_NEAR(sparse[n], full[n], is_long ? kTolerance * full[n] : 0.0F);
      }
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

// --- Zeros, sizes and extremes -----------------------------------------------------------------

TMpsomParameters small() {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  return p;
}

TEST(TMpsom, StartsFromUniformWeights) {
  TMpsomParameters p = small();
  p.weight_norm = TMpsomNorm::kNone;
  p.seed = 5;
  const TMpsom map(p);
  EXPECT_EQ(map.weights(0)(4, 2), uniform_at(5, Stream::kInitialWeights, 4, 2));
  EXPECT_EQ(map.weights(1)(4, 1), uniform_at(5, Stream::kInitialWeights, 4, 4));
}

TEST(TMpsom, KeepsAZeroVectorZero) {
  const std::vector<Matrix<float>> zeros{Matrix<float>(6, 3), Matrix<float>(6, 2, 0.5F)};
  TMpsomParameters p = small();
  p.combination = TMpsomCombination::kAdded;
  TMpsom map = *TMpsom::from_weights(p, zeros);
  EXPECT_TRUE(learn(map, dense({{0, 0, 0}, {1, 2}}), 0.5));
  EXPECT_EQ(map.weights(0), zeros[0]);
  EXPECT_NE(map.weights(1), zeros[1]);
}

// The strength of a normalized input does not matter, however far it is from 1.
TEST(TMpsom, NormalizesInputsOfAnyStrength) {
  const TMpsom map(small());
  const auto expected = activation(map, dense({{1, 2, 3}, {2, 1}}));
  for (const float strength : {1e-35F, 1e-20F, 1e20F, 1e37F}) {
    const auto activity =
        activation(map, dense({{strength, 2 * strength, 3 * strength}, {2 * strength, strength}}));
    for (std::size_t n = 0; n < expected.size(); ++n) {
      EXPECT_NEAR(activity[n], expected[n], 1e-5F * expected[n]) << strength;
    }
  }
}

// Squares of such weights are beyond float.
TEST(TMpsom, NormalizesWeightsOfAnyLength) {
  TMpsomParameters p = small();
  p.input_norm = TMpsomNorm::kNone;
  p.combination = TMpsomCombination::kAdded;
  for (const float strength : {1e-17F, 3e19F}) {
    TMpsom map =
        *TMpsom::from_weights(p, {Matrix<float>(6, 3, strength), Matrix<float>(6, 2, 1.0F)});
    EXPECT_TRUE(learn(map, dense({{strength / 10, 0, 0}, {0, 1}}), 0.5));
    const Matrix<float> weights = map.weights(0);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(length(weights.row(n)), 1.0, 1e-6) << strength;
  }
}

TEST(TMpsom, TakesTheFirstOfEqualWinners) {
  EXPECT_EQ(TMpsom::winner(std::vector{0.1F, 0.7F, 0.3F, 0.7F}), 1U);
  EXPECT_EQ(TMpsom::winner(std::vector{-0.7F, -0.1F}), 1U);
  EXPECT_THROW(TMpsom::winner({}), InvalidArgument);
}

TEST(TMpsom, RefusesInputsThatDoNotFit) {
  TMpsom map(small());
  const TMpsom before = map;
  EXPECT_THROW(activation(map, dense({{1, 2, 3}})), InvalidArgument);
  EXPECT_THROW(activation(map, dense({{1, 2, 3}, {1, 2, 3}})), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2}, {1, 2}}), 0.1), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, 2}}), 1.1), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, 2}}), -0.1), InvalidArgument);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_THROW(activation(map, dense({{1, nan, 3}, {1, 2}})), InvalidArgument);
  EXPECT_THROW(learn(map, dense({{1, 2, 3}, {1, infinity}}), 0.1), InvalidArgument);
  EXPECT_EQ(map, before);
}

TEST(TMpsom, RefusesActivityBeyondNumbers) {
  TMpsomParameters p = small();
  p.input_norm = TMpsomNorm::kNone;
  p.weight_norm = TMpsomNorm::kNone;
  TMpsom map = *TMpsom::from_weights(p, {Matrix<float>(6, 3, 1e30F), Matrix<float>(6, 2, 1.0F)});
  const TMpsom before = map;
  EXPECT_THROW(learn(map, dense({{1e30F, 0, 0}, {1, 1}}), 0.5), InvalidArgument);
  EXPECT_EQ(map, before);
}

TEST(TMpsom, RefusesTheWorkspaceOfAnotherMap) {
  TMpsom map(small());
  TMpsomParameters other = small();
  other.shape = {2, 2};
  TMpsom::Workspace workspace{TMpsom(other)};
  std::vector<float> activity(6);
  const auto inputs = dense({{1, 2, 3}, {1, 2}});
  EXPECT_THROW(map.activation(views(inputs), workspace, activity), InvalidArgument);
  TMpsom::Workspace own(map);
  activity.resize(5);
  EXPECT_THROW(map.activation(views(inputs), own, activity), InvalidArgument);
}

// --- Weights in and out ------------------------------------------------------------------------

TEST(TMpsom, IsTheSameFromItsOwnWeights) {
  TMpsom map(small());
  learn(map, dense({{1, 2, 3}, {1, 2}}), 0.5);
  const auto again = TMpsom::from_weights(map.parameters(), {map.weights(0), map.weights(1)});
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, map);
  EXPECT_FALSE(*again == TMpsom(small()));
  EXPECT_THROW(map.weights(2), InvalidArgument);
  EXPECT_THROW(map.arbor(2), InvalidArgument);
}

void expect_refused(const std::vector<Matrix<float>>& weights, const std::string& what) {
  const auto map = TMpsom::from_weights(small(), weights);
  ASSERT_FALSE(map) << what;
  EXPECT_EQ(map.error().kind, ErrorKind::kData);
  EXPECT_EQ(map.error().what, what);
}

TEST(TMpsom, RefusesWeightsThatDoNotFit) {
  expect_refused({Matrix<float>(6, 3)}, "weights of 1 inputs for a T-MPSOM of 2");
  expect_refused({Matrix<float>(6, 3), Matrix<float>(6, 3)},
                 "the weights of input 1 are 6 x 3, not 6 x 2");
  expect_refused({Matrix<float>(5, 3), Matrix<float>(6, 2)},
                 "the weights of input 0 are 5 x 3, not 6 x 3");
  expect_refused({Matrix<float>(6, 3), Matrix<float>(6, 2, std::nanf(""))},
                 "a weight of input 1 is not finite");
  const auto map = TMpsom::from_weights(TMpsomParameters{}, {});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::kUsage);
  EXPECT_THROW(TMpsom{TMpsomParameters{}}, InvalidArgument);
}

}  // namespace
}  // namespace somato
