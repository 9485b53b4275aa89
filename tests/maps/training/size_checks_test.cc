#include "maps/training/size_checks.h"

#include <gtest/gtest.h>

#include "somato/core/random.h"

namespace somato {
namespace {

Result<void> go_on() {
  return {};
}

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
  return measured_size(samples, similarity, threads, go_on).value();
}

TEST(SizeChecks, ErrorsFallWithEveryNeuronOfSpreadSamples) {
  const MeasuredSize size = measured(normal_samples(400, 2));
  EXPECT_EQ(size.share, 1.0);
  ASSERT_EQ(size.checks.size(), 5U);
  EXPECT_EQ(size.checks.front().neurons, 16U);  // 4 x 4 of 320 / 16
  EXPECT_EQ(size.checks.back().neurons, 289U);  // 17 x 17 of 320
  for (std::size_t i = 1; i < size.checks.size(); ++i) {
    EXPECT_LT(size.checks[i].error, size.checks[i - 1].error);
  }
}

TEST(SizeChecks, EqualSamplesNeedNoFurtherNeuron) {
  const MeasuredSize size = measured(four_points());
  EXPECT_LT(size.share, 0.5);
  EXPECT_LT(size.checks.size(), 5U);
  EXPECT_LT(size.checks.front().error, 0.1);
}

TEST(SizeChecks, ThreadsHaveNoEffect) {
  const Samples samples = normal_samples(150, 3);
  const MeasuredSize one = measured(samples, 1, Similarity::kManhattan);
  const MeasuredSize three = measured(samples, 3, Similarity::kManhattan);
  ASSERT_EQ(one.checks.size(), three.checks.size());
  for (std::size_t i = 0; i < one.checks.size(); ++i) {
    EXPECT_EQ(one.checks[i].error, three.checks[i].error);
  }
}

// Powers of two change no bit but the exponents.
TEST(SizeChecks, TheScaleOfSamplesHasNoEffect) {
  const MeasuredSize plain = measured(normal_samples(100, 3));
  const MeasuredSize scaled = measured(normal_samples(100, 3, 1024.0));
  EXPECT_EQ(scaled.share, plain.share);
  ASSERT_EQ(scaled.checks.size(), plain.checks.size());
  for (std::size_t i = 0; i < plain.checks.size(); ++i) {
    EXPECT_EQ(scaled.checks[i].error, 1024.0 * plain.checks[i].error);
  }
}

TEST(SizeChecks, FewEqualOrWideSamplesAreHarmless) {
  EXPECT_TRUE(measured(normal_samples(4, 3)).checks.empty());
  EXPECT_EQ(measured(normal_samples(5, 3)).checks.size(), 2U);  // 1 and 4 neurons
  EXPECT_FALSE(measured(Samples(Matrix<float>(30, 2))).checks.empty());
  EXPECT_FALSE(measured(normal_samples(6, 500)).checks.empty());
  EXPECT_FALSE(measured(normal_samples(20, 1, 1e15)).checks.empty());
}

TEST(SizeChecks, CanBeInterrupted) {
  const auto stop = []() -> Result<void> { return fail(ErrorKind::kInterrupted, "stopped"); };
  const auto found = measured_size(normal_samples(30, 2), Similarity::kEuclidean, 1, stop);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().kind, ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace somato
