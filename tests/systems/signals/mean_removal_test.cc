#include "systems/signals/mean_removal.h"

#include <gtest/gtest.h>

#include <vector>

namespace somato {
namespace {

TEST(MeanRemoval, SubtractsEachElementsOwnMean) {
  const Matrix<float> frames(3, 2, {1.0F, -10.0F, 2.0F, 0.0F, 6.0F, 40.0F});  // means 3 and 10
  EXPECT_EQ(mean_removed(frames), Matrix<float>(3, 2, {-2.0F, -20.0F, -1.0F, -10.0F, 3.0F, 30.0F}));
}

TEST(MeanRemoval, LeavesNothingOfASingleFrame) {
  EXPECT_EQ(mean_removed(Matrix<float>(1, 2, {7.0F, -0.1F})), Matrix<float>(1, 2, {0.0F, 0.0F}));
}

TEST(MeanRemoval, LeavesWhatHasNoFramesOrNoElements) {
  EXPECT_EQ(mean_removed(Matrix<float>(0, 3)), Matrix<float>(0, 3));
  EXPECT_EQ(mean_removed(Matrix<float>(3, 0)), Matrix<float>(3, 0));
}

// In single precision 2^24 swallows every further 1, and the mean would be 2^24 / 4.
TEST(MeanRemoval, AddsInDoublePrecision) {
  const Matrix<float> frames(4, 1, {16777216.0F, 1.0F, 1.0F, 2.0F});  // sum 2^24 + 4
  EXPECT_EQ(mean_removed(frames),
            Matrix<float>(4, 1, {12582911.0F, -4194304.0F, -4194304.0F, -4194303.0F}));
}

}  // namespace
}  // namespace somato
