#include "systems/signals/high_pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/no_malloc.h"
#include "somato/core/check.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Matrix<float> passed(Matrix<float> frames, double time_constant, double rate) {
  HighPass filter(frames.columns(), time_constant, rate);
  for (std::size_t i = 0; i < frames.rows(); ++i) filter.step(frames.row(i));
  return frames;
}

// T f = 1, so that a = 1 / 2.
TEST(HighPass, HalvesAStepWithEachFrame) {
  const Matrix<float> frames(5, 2, {7.0F, 1.0F, 7.0F, 1.0F, 15.0F, 1.0F, 15.0F, 1.0F, 15.0F, 5.0F});
  EXPECT_EQ(passed(frames, 0.1, 10.0),
            Matrix<float>(5, 2, {0.0F, 0.0F, 0.0F, 0.0F, 4.0F, 0.0F, 2.0F, 0.0F, 1.0F, 2.0F}));
}

// (1 + 1 / 1000)^-1000 = 1 / 2.716923932: a thousand frames are a time constant.
TEST(HighPass, DecaysByEInATimeConstant) {
  Matrix<float> frames(1002, 1, 1.0F);
  frames(0, 0) = 0.0F;
  const Matrix<float> out = passed(frames, 2.0, 500.0);
  EXPECT_NEAR(double{out(1000, 0)}, 1.0 / 2.716923932, 1e-6);
}

// A ramp of 1 / 32 per frame, 3.125 per second, tends to s T = 3.125 x 0.5: y = a (y + 1 / 32).
TEST(HighPass, LeavesOfASlowRampWhatItGainsInATimeConstant) {
  Matrix<float> frames(5000, 1);
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    frames(i, 0) = static_cast<float>(i) / 32.0F;
  }
  EXPECT_NEAR(double{passed(frames, 0.5, 100.0)(4999, 0)}, 3.125 * 0.5, 1e-6);
}

// Each output as a sum over all changes before: y(t) = sum of a^(t - i + 1) (x(i) - x(i - 1)).
Matrix<double> slowly_passed(const Matrix<float>& frames, double time_constant, double rate) {
  const double keep = time_constant / (time_constant + 1.0 / rate);
  Matrix<double> out(frames.rows(), frames.columns());
  for (std::size_t t = 0; t < frames.rows(); ++t) {
    for (std::size_t j = 0; j < frames.columns(); ++j) {
      double share = keep;
      for (std::size_t i = t; i > 0; --i, share *= keep) {
        out(t, j) += share * (double{frames(i, j)} - double{frames(i - 1, j)});
      }
    }
  }
  return out;
}

TEST(HighPass, IsThatOfItsDefinition) {
  Random random(5);
  for (int problem = 0; problem < 200; ++problem) {
    Matrix<float> frames(random.below(40), 1 + random.below(5));
    for (float& value : frames.values()) value = static_cast<float>(random.uniform());
    const double time_constant = 0.01 + random.uniform();
    const double rate = 1.0 + 200.0 * random.uniform();
    const Matrix<float> fast = passed(frames, time_constant, rate);
    const Matrix<double> slow = slowly_passed(frames, time_constant, rate);
    for (std::size_t i = 0; i < fast.values().size(); ++i) {
      ASSERT_NEAR(double{fast.values()[i]}, slow.values()[i], 1e-6);
    }
  }
}

TEST(HighPass, AllocatesNothingForAFrame) {
  HighPass filter(15, 1.0, 100.0);
  std::vector<float> frame(15, 1.0F);
  const testing::AllocationCounter counter;
  for (int i = 0; i < 20; ++i) filter.step(frame);
  EXPECT_EQ(counter.count(), 0U);
}

TEST(HighPass, RefusesWhatDoesNotFit) {
  EXPECT_THROW(HighPass(3, 0.0, 10.0), InvalidArgument);
  EXPECT_THROW(HighPass(3, 1.0, 0.0), InvalidArgument);
  EXPECT_THROW(HighPass(3, 1.0, std::numeric_limits<double>::infinity()), InvalidArgument);
  HighPass filter(3, 1.0, 10.0);
  std::vector<float> frame(2);
  EXPECT_THROW(filter.step(frame), InvalidArgument);
}

}  // namespace
}  // namespace somato
