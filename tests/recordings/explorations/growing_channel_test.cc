#include "recordings/explorations/growing_channel.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(GrowingChannel, MarksOfValidityBeginWithTheFirstInvalidValue) {
  Channel collected;
  add_frame(collected, std::vector<float>{1, 2}, 0.0);
  add_frame(collected, std::vector<float>{3, 0}, 0.5, std::vector<std::uint8_t>{1, 0});
  add_frame(collected, std::vector<float>{5, 6}, 1.0);
  ChannelDescription description;
  description.name = "touch";
  const Channel channel = described(collected, description, 2);
  EXPECT_EQ(channel.name, "touch");
  EXPECT_EQ(channel.frames, Matrix<float>(3, 2, {1, 2, 3, 0, 5, 6}));
  EXPECT_EQ(channel.valid, Matrix<std::uint8_t>(3, 2, {1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(channel.times, (std::vector<double>{0.0, 0.5, 1.0}));
}

TEST(GrowingChannel, TimesThatAreNotKnownAreLeftOut) {
  Channel collected;
  add_frame(collected, std::vector<float>{1}, 7.0);
  ChannelDescription description;
  description.times_known = false;
  EXPECT_TRUE(described(collected, description, 1).times.empty());
  EXPECT_EQ(described({}, description, 3).frames, Matrix<float>(0, 3));
}

TEST(GrowingChannel, AFrameOfAnotherSizeIsACallersMistake) {
  Channel channel;
  add_frame(channel, std::vector<float>{1, 2}, 0.0);
  EXPECT_THROW(add_frame(channel, std::vector<float>{1}, 0.1), InvalidArgument);
}

TEST(GrowingChannel, DropsTheOldestFramesWithTheirTimesAndMarks) {
  Channel channel;
  add_frame(channel, std::vector<float>{1, 2}, 0.0);
  add_frame(channel, std::vector<float>{0, 4}, 0.5, std::vector<std::uint8_t>{0, 1});
  add_frame(channel, std::vector<float>{5, 6}, 1.0);
  EXPECT_EQ(bytes_of(channel), 6 * sizeof(float) + 6 + 3 * sizeof(double));
  drop_frames(channel, 1);
  EXPECT_EQ(channel.frames, Matrix<float>(2, 2, {0, 4, 5, 6}));
  EXPECT_EQ(channel.valid, Matrix<std::uint8_t>(2, 2, {0, 1, 1, 1}));
  EXPECT_EQ(channel.times, (std::vector<double>{0.5, 1.0}));
  drop_frames(channel, 2);
  EXPECT_EQ(bytes_of(channel), 0U);
}

}  // namespace
}  // namespace somato
