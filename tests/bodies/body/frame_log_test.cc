#include "bodies/body/frame_log.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "somato/core/check.h"

namespace somato {
namespace {

BodyDescription three_sensors() {
  BodyDescription body;
  body.sensors = {{"touch", "N", {"a", "b"}, {}, 0.0, true},
                  {"sound", "V", {}, {}, 100.0, false},
                  {"unclocked", "", {}, {2, 1}, 0.0, false}};
  return body;
}

BodyState state_of(double time, std::vector<float> touch, std::vector<float> sound) {
  const std::size_t samples = sound.size();
  BodyState state;
  state.time = time;
  state.readings = {Matrix<float>(1, 2, std::move(touch)),
                    Matrix<float>(samples, samples == 0 ? 0 : 1, std::move(sound)),
                    Matrix<float>(1, 2, {7, 8})};
  return state;
}

TEST(FrameLog, KeepsFramesWithTheTimesAtWhichTheyWereTaken) {
  FrameLog log(three_sensors());
  ASSERT_TRUE(log.append(state_of(0.25, {1, 2}, {10, 20, 30})));
  ASSERT_TRUE(log.append(state_of(0.5, {3, 4}, {40})));
  ASSERT_TRUE(log.append(state_of(2, {5, 6}, {})));
  const std::vector<Channel> channels = std::move(log).channels();
  ASSERT_EQ(channels.size(), 3U);
  EXPECT_EQ(
      channels[0],
      (Channel{"touch", "N", {"a", "b"}, Matrix<float>(3, 2, {1, 2, 3, 4, 5, 6}), {0.25, 0.5, 2}}));
  EXPECT_EQ(channels[1].frames, Matrix<float>(4, 1, {10, 20, 30, 40}));
  EXPECT_EQ(channels[1].times, (std::vector<double>{0.25 - 0.02, 0.25 - 0.01, 0.25, 0.5}));
  EXPECT_EQ(channels[1].rate, 0.0);
  EXPECT_EQ(channels[2].frames.rows(), 3U);
  EXPECT_EQ(channels[2].shape, (std::vector<std::size_t>{2, 1}));
  EXPECT_TRUE(channels[2].times.empty());
  EXPECT_TRUE(validate(Recording{{{{}, {}, channels}}}));
}

TEST(FrameLog, MarksMissingReadings) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  FrameLog log(three_sensors());
  ASSERT_TRUE(log.append(state_of(0.25, {1, 2}, {10})));
  ASSERT_TRUE(log.append(state_of(0.5, {3, kNone}, {20, kNone})));
  ASSERT_TRUE(log.append(state_of(2, {5, 6}, {})));
  const std::vector<Channel> channels = std::move(log).channels();
  EXPECT_EQ(channels[0].frames, Matrix<float>(3, 2, {1, 2, 3, 0, 5, 6}));
  EXPECT_EQ(channels[0].valid,
            Matrix<std::uint8_t>(3, 2, std::vector<std::uint8_t>{1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(channels[1].valid, Matrix<std::uint8_t>(3, 1, std::vector<std::uint8_t>{1, 1, 0}));
  EXPECT_TRUE(channels[2].valid.empty());
  EXPECT_TRUE(validate(Recording{{{{}, {}, channels}}}));
}

TEST(FrameLog, KeepsFramesOfASensorWithTimesOfItsOwn) {
  FrameLog log(three_sensors());
  BodyState skin = state_of(0.5, {0, 0}, {});
  skin.readings[0] = Matrix<float>(3, 2, {1, 2, 3, 4, 5, 6});
  skin.times = {{0.1, 0.2, 0.45}, {}, {}};
  ASSERT_TRUE(log.append(skin));
  skin.time = 1.0;
  skin.readings[0] = Matrix<float>(0, 2);
  skin.times[0].clear();
  ASSERT_TRUE(log.append(skin));
  skin.time = 1.5;
  skin.readings[0] = Matrix<float>(1, 2, {7, 8});
  skin.times[0] = {1.25};
  ASSERT_TRUE(log.append(skin));
  skin.readings[0] = Matrix<float>(2, 2, 0.0F);
  EXPECT_EQ(log.append(skin).error().where, "touch");
  const std::vector<Channel> channels = std::move(log).channels();
  EXPECT_EQ(channels[0].frames, Matrix<float>(4, 2, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(channels[0].times, (std::vector<double>{0.1, 0.2, 0.45, 1.25}));
  EXPECT_EQ(channels[2].frames.rows(), 3U);
}

TEST(FrameLog, AReadingThatDoesNotFitNamesItsSensor) {
  FrameLog log(three_sensors());
  BodyState wide = state_of(1, {1, 2}, {1});
  wide.readings[0] = Matrix<float>(1, 3, 0.0F);
  EXPECT_EQ(log.append(wide).error().where, "touch");
  BodyState twice = state_of(1, {1, 2}, {1});
  twice.readings[2] = Matrix<float>(2, 2, 0.0F);
  EXPECT_EQ(log.append(twice).error().where, "unclocked");
  ASSERT_TRUE(log.append(state_of(1, {1, 2}, {1})));
  BodyState other = state_of(2, {1, 2}, {1});
  other.readings[1] = Matrix<float>(1, 2, 0.0F);
  const auto refused = log.append(other);
  EXPECT_EQ(refused.error().where, "sound");
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
}

// 40 bytes of values and times in a step: 24 of touch and sound with their times, 16 unclocked.
TEST(FrameLog, DropsAllFramesThatTakeTooMuchMemory) {
  for (const std::size_t steps : {2U, 3U, 50U}) {
    FrameLog log(three_sensors(), 110);
    for (std::size_t step = 0; step < steps; ++step) {
      ASSERT_TRUE(log.append(state_of(static_cast<double>(step), {1, 2}, {1})));
    }
    const std::vector<Channel> channels = std::move(log).channels();
    for (const Channel& channel : channels) {
      EXPECT_EQ(channel.frames.rows(), steps == 2 ? 2U : 0U) << channel.name << " " << steps;
    }
    EXPECT_EQ(channels[0].frames.columns(), 2U);
    EXPECT_TRUE(steps == 2 || channels[0].times.empty());
  }
}

TEST(FrameLog, ReadingsOfAnotherBodyAreACallersMistake) {
  FrameLog log(three_sensors());
  EXPECT_THROW((void)log.append(BodyState{}), InvalidArgument);
}

}  // namespace
}  // namespace somato
