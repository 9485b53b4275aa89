#include "recordings/explorations/growing_channel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

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

// A missing value is NaN among readings, and 0 with a mark in a channel.
TEST(GrowingChannel, ReadingsComeBackWithTheirMissingValues) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  Channel channel;
  append_readings(channel, Matrix<float>(2, 2, {1, 2, 3, 4}));
  EXPECT_TRUE(channel.valid.empty());
  append_readings(channel, Matrix<float>(2, 2, {5, kNone, 0, 8}));
  EXPECT_EQ(channel.frames, Matrix<float>(4, 2, {1, 2, 3, 4, 5, 0, 0, 8}));
  EXPECT_EQ(channel.valid, Matrix<std::uint8_t>(4, 2, {1, 1, 1, 1, 1, 0, 1, 1}));
  const Matrix<float> read = readings_of(channel, 1, 3);
  ASSERT_EQ(read.rows(), 3U);
  EXPECT_EQ(read(0, 1), 4.0F);
  EXPECT_TRUE(std::isnan(read(1, 1)));
  EXPECT_EQ(read(2, 0), 0.0F) << "a value of 0 is not missing";
  EXPECT_EQ(readings_of(channel, 4, 0), Matrix<float>(0, 2));
}

// Against a queue of numbers, with more added than taken and the reverse.
TEST(WaitingFrames, AreTakenFromTheOldestOn) {
  WaitingFrames waiting(1);
  EXPECT_EQ(waiting.take(0), Matrix<float>(0, 1));
  std::deque<float> expected;
  Random random(7);
  float next = 0.0F;
  for (int round = 0; round < 200; ++round) {
    const std::size_t most = round < 100 ? 6 : 2;
    for (std::uint64_t i = random.below(most); i > 0; --i) {
      waiting.add(std::vector<float>{next}, double{next});
      expected.push_back(next++);
    }
    const std::size_t count = std::min<std::size_t>(random.below(4), expected.size());
    ASSERT_EQ(waiting.count(), expected.size());
    const std::vector<double> times(waiting.times().begin(), waiting.times().end());
    EXPECT_EQ(times, std::vector<double>(expected.begin(), expected.end()));
    const Matrix<float> taken = waiting.take(count);
    for (std::size_t i = 0; i < count; ++i, expected.pop_front()) {
      EXPECT_EQ(taken(i, 0), expected.front());
    }
  }
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
