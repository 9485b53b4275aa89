#include "systems/signals/tare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/support/no_malloc.h"
#include "somato/core/check.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Matrix<float> tared(Matrix<float> frames, std::size_t first) {
  Tare tare(frames.columns(), {first});
  for (std::size_t i = 0; i < frames.rows(); ++i) tare.step(frames.row(i));
  return frames;
}

TEST(Tare, SubtractsTheMeanOfTheFirstFrames) {
  // Means of the first element: 4, then (4 + 8) / 2 = 6 for all others.
  const Matrix<float> frames(4, 2, {4.0F, -1.0F, 8.0F, -3.0F, 6.0F, -2.0F, 16.0F, 0.0F});
  EXPECT_EQ(tared(frames, 2),
            Matrix<float>(4, 2, {0.0F, 0.0F, 2.0F, -1.0F, 0.0F, 0.0F, 10.0F, 2.0F}));
  EXPECT_EQ(tared(frames, 1),
            Matrix<float>(4, 2, {0.0F, 0.0F, 4.0F, -2.0F, 2.0F, -1.0F, 12.0F, 1.0F}));
}

TEST(Tare, OfFewerFramesThanItAveragesSubtractsTheMeanSoFar) {
  const Matrix<float> frames(3, 1, {3.0F, 5.0F, 10.0F});  // means 3, 4, 6
  EXPECT_EQ(tared(frames, 100), Matrix<float>(3, 1, {0.0F, 1.0F, 4.0F}));
}

// In single precision 2^24 swallows a further 1, and the mean of the first two would be 2^23.
TEST(Tare, AddsInDoublePrecision) {
  const Matrix<float> frames(3, 1, {16777216.0F, 2.0F, 8388609.0F});  // mean 2^23 + 1
  EXPECT_EQ(tared(frames, 2)(2, 0), 0.0F);
}

// Each output from the definition, with sums formed anew.
Matrix<float> slowly_tared(const Matrix<float>& frames, std::size_t first) {
  Matrix<float> out(frames.rows(), frames.columns());
  for (std::size_t t = 0; t < frames.rows(); ++t) {
    for (std::size_t j = 0; j < frames.columns(); ++j) {
      const std::size_t count = std::min(t + 1, first);
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) sum += double{frames(i, j)};
      out(t, j) = static_cast<float>(double{frames(t, j)} - sum / static_cast<double>(count));
    }
  }
  return out;
}

TEST(Tare, IsThatOfItsDefinition) {
  Random random(5);
  for (int problem = 0; problem < 200; ++problem) {
    Matrix<float> frames(random.below(30), 1 + random.below(5));
    for (float& value : frames.values()) value = static_cast<float>(100.0 * random.uniform());
    const std::size_t first = 1 + random.below(20);
    EXPECT_EQ(tared(frames, first), slowly_tared(frames, first));
  }
}

// The values of a sensor at rest do not matter, nor how they differ from one exploration to
// another.
TEST(Tare, IsIndependentOfTheZero) {
  Matrix<float> frames(50, 2);
  Random random(6);
  for (float& value : frames.values()) value = static_cast<float>(random.below(1000));
  Matrix<float> moved = frames;
  for (float& value : moved.values()) value += 4096.0F;
  EXPECT_EQ(tared(frames, 8), tared(moved, 8));
}

TEST(Tare, AllocatesNothingForAFrame) {
  Tare tare(15, {10});
  std::vector<float> frame(15, 1.0F);
  const testing::AllocationCounter counter;
  for (int i = 0; i < 20; ++i) tare.step(frame);
  EXPECT_EQ(counter.count(), 0U);
}

TEST(Tare, RefusesWhatDoesNotFit) {
  EXPECT_THROW(Tare(3, {0}), InvalidArgument);
  Tare tare(3, {1});
  std::vector<float> frame(2);
  EXPECT_THROW(tare.step(frame), InvalidArgument);
}

}  // namespace
}  // namespace somato
