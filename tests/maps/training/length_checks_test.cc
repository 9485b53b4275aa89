#include "maps/training/length_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "maps/support/random_maps.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

SomParameters automatic(double tolerance, std::uint64_t patience) {
  SomParameters p;
  p.tolerance = tolerance;
  p.patience = patience;
  return p;
}

std::uint64_t checks_until_end(const SomParameters& parameters, const std::vector<double>& errors) {
  LengthChecks checks(parameters);
  for (const double error : errors) {
    if (!checks.go_on()) break;
    checks.add(error);
  }
  return checks.state().checks;
}

TEST(LengthChecks, EndAfterChecksWithoutImprovement) {
  const std::vector<double> errors{10, 9, 8.95, 8.94, 8, 8, 7.95, 7.9, 1, 1, 1, 1};
  EXPECT_EQ(checks_until_end(automatic(0.0, 1), errors), 0U);
  EXPECT_EQ(checks_until_end(automatic(0.05, 1), errors), 3U);
  EXPECT_EQ(checks_until_end(automatic(0.05, 2), errors), 4U);
  EXPECT_EQ(checks_until_end(automatic(0.05, 3), errors), 8U);
  EXPECT_EQ(checks_until_end(automatic(0.05, 4), errors), 12U);
  // 7.9 is 1.25 % below 8, of which each step is less.
  EXPECT_EQ(checks_until_end(automatic(0.01, 3), errors), 12U);
}

TEST(LengthChecks, EndAtAnErrorOfZeroOrOneThatIsNoNumber) {
  EXPECT_EQ(checks_until_end(automatic(0.1, 2), {0, 0, 0, 0}), 3U);
  const double none = std::nan("");
  EXPECT_EQ(checks_until_end(automatic(0.1, 2), {none, none, none, none}), 3U);
}

TEST(LengthChecks, EndAfterTheMostChecks) {
  SomParameters p = automatic(0.1, 2);
  p.most_checks = 4;
  EXPECT_EQ(checks_until_end(p, {64, 32, 16, 8, 4, 2, 1}), 4U);
  p.most_checks = 1;
  EXPECT_EQ(checks_until_end(p, {64, 32}), 1U);
}

TEST(LengthChecks, KnowHowManyAreLeft) {
  SomParameters p = automatic(0.1, 3);
  LengthChecks checks(p);
  EXPECT_EQ(checks.checks_left(), 4U);
  checks.add(5.0);
  EXPECT_EQ(checks.checks_left(), 3U);
  checks.add(5.0);
  EXPECT_EQ(checks.checks_left(), 2U);
  checks.add(1.0);
  EXPECT_EQ(checks.checks_left(), 3U);
  p.most_checks = 5;
  LengthChecks few(p);
  few.restore(checks.state());
  EXPECT_EQ(few.checks_left(), 2U);
}

// The number of steps after which training should end, with an error measured on a map of each
// length: training of a fixed length with the same schedule.
std::uint64_t expected_steps(
    SomParameters p, const Samples& samples, std::uint64_t first, std::uint64_t step, bool before,
    const std::function<Som(const SomParameters&, std::uint64_t)>& trained) {
  double least = 0.0;
  std::uint64_t without = 0;
  for (std::uint64_t check = 0; check < p.most_checks; ++check) {
    const std::uint64_t steps = first + check * step;
    const double error = measure_quality(trained(p, steps), samples).quantization_error;
    const bool improves = check == 0 || error < (1.0 - p.tolerance) * least;
    if (improves) least = error;
    without = improves ? 0 : without + 1;
    if (without == p.patience || check + 1 == p.most_checks) return steps + (before ? step : 0);
  }
  return 0;
}

Som of_length(SomParameters p, const Samples& samples, std::uint64_t steps) {
  p.tolerance = 0.0;
  (p.training == Training::kBatch ? p.epochs : *p.iterations) = steps;
  return train_som(p, samples).value();
}

struct Trained {
  Som som;
  std::uint64_t steps = 0;
};

Trained of_automatic_length(const SomParameters& p, const Samples& samples,
                            std::size_t threads = 1) {
  Trained trained;
  TrainingOptions options;
  options.threads = threads;
  options.steps_done = &trained.steps;
  trained.som = train_som(p, samples, options).value();
  return trained;
}

SomParameters small_map(const testing::Variant& variant, Random& random) {
  SomParameters p = testing::random_parameters(variant, random);
  p.tolerance = 0.002;
  p.patience = 1 + random.below(3);
  p.most_checks = 1 + random.below(12);
  return p;
}

TEST(SomTrainingThread, OfAutomaticLengthInEpochsEndsWhenTheErrorNoLongerImproves) {
  Random random(31);
  for (const bool products : {false, true}) {
    for (const auto& variant :
         products ? testing::variants_by_products() : testing::all_variants()) {
      const Samples samples = testing::random_samples(30, products ? 40 : 4, false, random);
      SomParameters p = small_map(variant, random);
      p.training = Training::kBatch;
      p.arithmetic = products ? Arithmetic::kInnerProducts : Arithmetic::kPlain;
      p.epochs = random.below(3);
      p.radius_reached_at = 2;
      const std::uint64_t steps = expected_steps(
          p, samples, p.epochs, 1, true,
          [&](const SomParameters& q, std::uint64_t n) { return of_length(q, samples, n); });
      for (const std::size_t threads : {1U, 3U}) {
        const Trained found = of_automatic_length(p, samples, threads);
        EXPECT_EQ(found.steps, steps) << testing::name_of(variant);
        EXPECT_EQ(found.som.weights(), of_length(p, samples, steps).weights());
      }
      EXPECT_GE(steps, p.epochs + 1);
    }
  }
}

TEST(SomTrainingThread, OfAutomaticLengthInIterationsEndsWhenTheErrorNoLongerImproves) {
  Random random(32);
  for (const bool products : {false, true}) {
    for (const auto& variant :
         products ? testing::variants_by_products() : testing::all_variants()) {
      const bool sparse = random.below(2) == 0;
      const Samples samples = testing::random_samples(30, products ? 40 : 4, sparse, random);
      SomParameters p = small_map(variant, random);
      p.arithmetic = products ? Arithmetic::kInnerProducts : Arithmetic::kPlain;
      p.iterations = random.below(100);
      p.radius_reached_at = 40;
      p.learning_rate_reached_at = 50;
      const std::uint64_t steps = expected_steps(
          p, samples, *p.iterations, 30, false,
          [&](const SomParameters& q, std::uint64_t n) { return of_length(q, samples, n); });
      for (const std::size_t threads : {1U, 3U}) {
        const Trained found = of_automatic_length(p, samples, threads);
        EXPECT_EQ(found.steps, steps) << testing::name_of(variant);
        EXPECT_EQ(found.som.weights(), of_length(p, samples, steps).weights());
      }
    }
  }
}

TEST(SomTraining, OfAFixedLengthMakesItsSteps) {
  Random random(33);
  const Samples samples = testing::random_samples(10, 3, false, random);
  SomParameters p;
  p.iterations = 77;
  EXPECT_EQ(of_automatic_length(p, samples).steps, 77U);
  p.training = Training::kBatch;
  p.epochs = 5;
  EXPECT_EQ(of_automatic_length(p, samples).steps, 5U);
}

TEST(SomTraining, OfAutomaticLengthReportsATotalThatItReaches) {
  Random random(34);
  const Samples samples = testing::random_samples(20, 3, false, random);
  for (const auto training : {Training::kOnline, Training::kBatch}) {
    SomParameters p;
    p.training = training;
    p.iterations = 64;
    p.epochs = 3;
    p.tolerance = 0.01;
    std::uint64_t last = 0;
    std::uint64_t of = 0;
    std::uint64_t moment = 0;
    TrainingOptions options;
    options.progress = [&](std::uint64_t done, std::uint64_t total) {
      EXPECT_GE(done, last);
      EXPECT_LE(done, total);
      last = done;
      of = total;
      return true;
    };
    options.observer = [&](const TrainingMoment& now) {
      EXPECT_GT(now.step, moment);
      EXPECT_LE(now.step, now.steps);
      moment = now.step;
      return true;
    };
    std::uint64_t steps = 0;
    options.steps_done = &steps;
    ASSERT_TRUE(train_som(p, samples, options));
    EXPECT_EQ(last, steps);
    EXPECT_EQ(moment, steps);
    EXPECT_EQ(of, steps);
  }
}

TEST(SomTraining, OfAutomaticLengthHandlesOneSampleAndEqualSamples) {
  for (const std::size_t count : {1U, 5U}) {
    const Samples samples(Matrix<float>(count, 2, 3.0F));
    for (const auto training : {Training::kOnline, Training::kBatch}) {
      SomParameters p;
      p.training = training;
      p.tolerance = 0.5;
      p.iterations = 3;
      p.most_checks = 20;
      const Trained found = of_automatic_length(p, samples);
      EXPECT_GT(found.steps, 3U);
    }
  }
}

}  // namespace
}  // namespace somato
