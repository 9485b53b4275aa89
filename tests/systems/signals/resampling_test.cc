#include "systems/signals/resampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Matrix<float> resample(const Matrix<float>& frames, std::size_t points) {
  return resampled(frames, {points}).value();
}

Matrix<float> column_of(std::vector<float> values) {
  const std::size_t count = values.size();
  return Matrix<float>(count, 1, std::move(values));
}

Matrix<float> random_frames(std::uint64_t seed, std::size_t frames, std::size_t elements) {
  Random random(seed);
  Matrix<float> made(frames, elements);
  for (float& value : made.values()) value = static_cast<float>(random.normal());
  return made;
}

TEST(Resampling, InterpolatesBetweenNeighbours) {
  EXPECT_EQ(resample(column_of({0.0F, 4.0F, -4.0F}), 5),
            column_of({0.0F, 2.0F, 4.0F, 0.0F, -4.0F}));
}

TEST(Resampling, LeavesOutFramesBetweenItsPoints) {
  EXPECT_EQ(resample(column_of({0, 1, 4, 9, 16, 25, 36}), 3), column_of({0, 9, 36}));
  EXPECT_EQ(resample(column_of({0, 1, 4, 9}), 3), column_of({0.0F, 2.5F, 9.0F}));
}

TEST(Resampling, TreatsEveryElementOnItsOwn) {
  EXPECT_EQ(resample(Matrix<float>(2, 2, {0.0F, 10.0F, 1.0F, 30.0F}), 3),
            Matrix<float>(3, 2, {0.0F, 10.0F, 0.5F, 20.0F, 1.0F, 30.0F}));
}

TEST(Resampling, IsTheSameForAsManyPointsAsFrames) {
  const Matrix<float> frames = random_frames(1, 7, 3);
  EXPECT_EQ(resample(frames, 7), frames);
}

TEST(Resampling, RepeatsASingleFrame) {
  EXPECT_EQ(resample(Matrix<float>(1, 2, {3.0F, 0.1F}), 2),
            Matrix<float>(2, 2, {3.0F, 0.1F, 3.0F, 0.1F}));
}

TEST(Resampling, KeepsTheFirstAndTheLastFrameExactly) {
  for (std::size_t count = 2; count < 40; ++count) {
    const Matrix<float> frames = random_frames(count, count, 1);
    for (std::size_t points = 2; points < 40; ++points) {
      const Matrix<float> result = resample(frames, points);
      EXPECT_EQ(result(0, 0), frames(0, 0));
      EXPECT_EQ(result(points - 1, 0), frames(count - 1, 0));
    }
  }
}

// The oracle walks along the time axis in long double and mixes the two frames around it.
TEST(Resampling, AgreesWithInterpolationAtEveryPlace) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const std::size_t count = 2 + random.below(30);
    const std::size_t points = 2 + random.below(60);
    const Matrix<float> frames = random_frames(100 + static_cast<std::uint64_t>(i), count, 1);
    const Matrix<float> result = resample(frames, points);
    for (std::size_t point = 0; point < points; ++point) {
      const long double place = static_cast<long double>(point * (count - 1)) / (points - 1);
      const auto frame = std::min(static_cast<std::size_t>(std::floor(place)), count - 2);
      const long double share = place - static_cast<long double>(frame);
      const long double expected = (1 - share) * frames(frame, 0) + share * frames(frame + 1, 0);
      EXPECT_NEAR(result(point, 0), static_cast<double>(expected), 1e-6);
    }
  }
}

TEST(Resampling, RefusesNoFrames) {
  const auto result = resampled(Matrix<float>(0, 3), {4});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kData);
  EXPECT_EQ(result.error().what, "there are no frames to resample");
}

TEST(Resampling, NeedsTwoPoints) {
  EXPECT_THROW((void)resampled(Matrix<float>(2, 2), {1}), InvalidArgument);
  const Table table{"", {{"points", "", Value{std::int64_t{1}}}}};
  EXPECT_FALSE(read_parameters<ResamplingParameters>(table));
}

TEST(ResamplingParameters, AreReadByTheirNames) {
  const Table table{"", {{"points", "", Value{std::int64_t{64}}}}};
  EXPECT_EQ(read_parameters<ResamplingParameters>(table)->points, 64U);
}

}  // namespace
}  // namespace somato
