#include "somato/maps/measured_size.h"

#include <gtest/gtest.h>

#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Samples normal_samples(std::size_t count, std::size_t features, double scale = 1.0) {
  Random random(5);
  Matrix<float> values(count, features);
  for (float& value : values.values()) value = static_cast<float>(scale * random.normal());
  return Samples(std::move(values));
}

// Four points, each of 75 samples: a few neurons are enough.
Samples four_points() {
  Matrix<float> values(300, 2);
  for (std::size_t i = 0; i < values.rows(); ++i) {
    values(i, 0) = i / 75 % 2 ? 10.0F : 0.0F;
    values(i, 1) = i / 150 ? 10.0F : 0.0F;
  }
  return Samples(std::move(values));
}

MeasuredSize measured(const Samples& samples, std::size_t threads = 1,
                      Similarity similarity = Similarity::kEuclidean) {
  SomParameters parameters;
  parameters.similarity = similarity;
  return measured_size(parameters, samples, {.threads = threads}).value();
}

TEST(MeasuredSize, ErrorsFallWithEveryNeuronOfSpreadSamples) {
  const MeasuredSize size = measured(normal_samples(400, 2));
  EXPECT_EQ(size.share, 1.0);
  ASSERT_EQ(size.checks.size(), 5U);
  EXPECT_EQ(size.checks.front().neurons, 20U);  // 4 x 5 of 320 / 16
  EXPECT_EQ(size.checks.back().neurons, 306U);  // 17 x 18 of 320
  for (std::size_t i = 1; i < size.checks.size(); ++i) {
    EXPECT_LT(size.checks[i].error, size.checks[i - 1].error);
  }
}

TEST(MeasuredSize, EqualSamplesNeedNoFurtherNeuron) {
  const MeasuredSize size = measured(four_points());
  EXPECT_EQ(size.share, 1.0 / 16);
  EXPECT_LT(size.checks.front().error, 0.1);
}

// Two groups at a distance, within which samples are spread.
TEST(MeasuredSize, SpreadWithinDistantGroupsCounts) {
  Random random(3);
  Matrix<float> values(100, 2);
  for (std::size_t i = 0; i < values.rows(); ++i) {
    values(i, 0) = static_cast<float>(1000.0 * static_cast<double>(i % 2) + random.normal());
    values(i, 1) = static_cast<float>(random.normal());
  }
  EXPECT_GE(measured(Samples(std::move(values))).share, 0.5);
}

// Every fifth sample is of the same group, which must not be the one that is held out.
TEST(MeasuredSize, SamplesInARegularOrderAreMeasuredLikeOthers) {
  Random random(4);
  Matrix<float> values(300, 2);
  for (std::size_t i = 0; i < values.rows(); ++i) {
    values(i, 0) = static_cast<float>(100.0 * static_cast<double>(i % 5) + random.normal());
    values(i, 1) = static_cast<float>(random.normal());
  }
  EXPECT_GE(measured(Samples(std::move(values))).share, 0.5);
}

// Every second sample is the same, and fewer are measured than there are.
TEST(MeasuredSize, ManySamplesAreDrawnAtRandom) {
  Random random(6);
  Matrix<float> values(5000, 2);
  for (std::size_t i = 0; i < values.rows(); i += 2) {
    values(i, 0) = static_cast<float>(random.normal());
    values(i, 1) = static_cast<float>(random.normal());
  }
  const auto sized = sized_by_measurement({}, Samples(std::move(values)), {.threads = 2}).value();
  EXPECT_GE(sized.size.share, 0.25);
}

TEST(MeasuredSize, ThreadsHaveNoEffect) {
  const Samples samples = normal_samples(150, 3);
  const MeasuredSize one = measured(samples, 1, Similarity::kManhattan);
  const MeasuredSize three = measured(samples, 3, Similarity::kManhattan);
  ASSERT_EQ(one.checks.size(), three.checks.size());
  for (std::size_t i = 0; i < one.checks.size(); ++i) {
    EXPECT_EQ(one.checks[i].error, three.checks[i].error);
  }
}

// Powers of two change no bit but the exponents.
TEST(MeasuredSize, TheScaleOfSamplesHasNoEffect) {
  const MeasuredSize plain = measured(normal_samples(100, 3));
  const MeasuredSize scaled = measured(normal_samples(100, 3, 1024.0));
  EXPECT_EQ(scaled.share, plain.share);
  ASSERT_EQ(scaled.checks.size(), plain.checks.size());
  for (std::size_t i = 0; i < plain.checks.size(); ++i) {
    EXPECT_EQ(scaled.checks[i].error, 1024.0 * plain.checks[i].error);
  }
}

TEST(MeasuredSize, FewEqualOrWideSamplesAreHarmless) {
  EXPECT_TRUE(measured(normal_samples(49, 3)).checks.empty());
  EXPECT_EQ(measured(normal_samples(50, 3)).checks.size(), 5U);
  EXPECT_EQ(measured(Samples(Matrix<float>(50, 2))).share, 1.0 / 16);  // all are equal
  EXPECT_FALSE(measured(normal_samples(50, 300)).checks.empty());
  EXPECT_FALSE(measured(normal_samples(50, 1, 1e15)).checks.empty());
}

TEST(MeasuredSize, CanBeInterrupted) {
  const auto stop = []() -> Result<void> { return fail(ErrorKind::kInterrupted, "stopped"); };
  const auto found = measured_size({}, normal_samples(60, 2), {.proceed = stop});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().kind, ErrorKind::kInterrupted);
}

TEST(MeasuredSize, TheMapHasAtMostAsManyNeuronsAsSamples) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 11U, 49U, 60U}) {
    const auto sized = sized_by_measurement({}, normal_samples(count, 3)).value();
    const std::size_t neurons = sized.parameters.grid().size();
    EXPECT_LE(neurons, count);
    EXPECT_GE(2 * neurons, count);  // spread samples need all
    EXPECT_TRUE(train_som(sized.parameters, normal_samples(count, 3)).has_value());
  }
}

TEST(MeasuredSize, FewDifferentSamplesNeedFewNeurons) {
  const Samples samples = four_points();
  const SizedParameters sized = sized_by_measurement({}, samples).value();
  EXPECT_LE(sized.parameters.grid().size(), 150U);
  EXPECT_EQ(sized.size.share, measured(samples).share);
}

TEST(MeasuredSize, TimeLimitsTheNumberOfNeurons) {
  EXPECT_EQ(most_neurons(2500), 2500.0);
  EXPECT_EQ(most_neurons(10000), 5000.0);  // 50 x 100
}

TEST(MeasuredSize, TheRestOfTheParametersIsKept) {
  SomParameters given;
  given.similarity = Similarity::kManhattan;
  given.lattice = Lattice::kHexagonal;
  given.topology = Topology::kTorus;
  given.seed = 7;
  const SomParameters sized = sized_by_measurement(given, normal_samples(30, 3)).value().parameters;
  EXPECT_EQ(sized.similarity, Similarity::kManhattan);
  EXPECT_EQ(sized.lattice, Lattice::kHexagonal);
  EXPECT_EQ(sized.seed, 7U);
  EXPECT_EQ(*sized.rows % 2, 0U);  // as the torus requires
  EXPECT_TRUE(train_som(sized, normal_samples(30, 3)).has_value());
}

TEST(MeasuredSize, TheRadiusBeginsAtAnEighthOfTheLongerSide) {
  EXPECT_EQ(with_size({}, 16, 40).radius_start, 5.0);
  EXPECT_EQ(with_size({}, 2, 3).radius_start, 1.0);
  EXPECT_THROW(with_size({}, 0, 3), InvalidArgument);
}

TEST(MeasuredSize, ParametersThatItDecidesHaveNoEffect) {
  SomParameters given;
  given.rows = 3;
  given.radius_schedule = ScheduleShape::kConstant;
  given.radius_end = 2.0;
  given.epochs = 1;
  const Samples samples = normal_samples(40, 3);
  const SomParameters sized = sized_by_measurement(given, samples).value().parameters;
  const SomParameters plain = sized_by_measurement({}, samples).value().parameters;
  for (const auto& parameter : SomParameters::declarations().all()) {
    const bool is_same = parameter.read(sized) == parameter.read(plain);
    const bool is_decided =
        !reason_without_effect(SizeChoice::kMeasured, parameter.info.name).empty();
    EXPECT_TRUE(is_same) << parameter.info.name;
    EXPECT_TRUE(reason_without_effect(SizeChoice::kByNumber, parameter.info.name).empty());
    const bool is_changed = parameter.read(plain) != parameter.read(SomParameters());
    EXPECT_TRUE(is_decided || !is_changed) << parameter.info.name;
  }
}

TEST(MeasuredSize, MissingValuesAndNegativeFactorsAreRefused) {
  Matrix<float> values(10, 2, 1.0F);
  values(3, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sized_by_measurement({}, Samples(std::move(values))).error().kind, ErrorKind::kData);
  SomParameters mexican;
  mexican.neighbourhood = NeighbourhoodShape::kMexicanHat;
  EXPECT_EQ(sized_by_measurement(mexican, normal_samples(10, 2)).error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
