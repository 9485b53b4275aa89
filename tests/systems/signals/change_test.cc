#include "systems/signals/change.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(Change, IsTheLastFrameLessTheFirst) {
  const Matrix<float> frames(3, 2, {1.0F, 5.0F, 100.0F, 100.0F, 4.0F, 3.0F});
  EXPECT_EQ(change_of(frames), Signal::dense({3.0F, -2.0F}));
}

TEST(Change, IsZeroForASingleFrame) {
  EXPECT_EQ(change_of(Matrix<float>(1, 2, {7.0F, 8.0F})), Signal::dense({0.0F, 0.0F}));
}

TEST(Change, RefusesNoFrames) {
  const Result<Signal> change = change_of(Matrix<float>(0, 2));
  ASSERT_FALSE(change);
  EXPECT_EQ(change.error().kind, ErrorKind::kData);
  EXPECT_EQ(change.error().what, "the channel has no frames");
}

}  // namespace
}  // namespace somato
