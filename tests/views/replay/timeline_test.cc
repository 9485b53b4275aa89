#include "views/replay/timeline.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

Channel channel(std::size_t frames, double rate = 0.0, std::vector<double> times = {}) {
  Channel made;
  made.name = "c" + std::to_string(frames);
  made.frames = Matrix<float>(frames, 1, 1.0F);
  made.rate = rate;
  made.times = std::move(times);
  return made;
}

TEST(Timeline, HasAMomentAFrame) {
  const Timeline timeline(Exploration{{}, {}, {channel(3, 0.0, {5.0, 5.5, 7.0})}});
  ASSERT_EQ(timeline.moments(), 3U);
  EXPECT_DOUBLE_EQ(timeline.time(0), 0.0);
  EXPECT_DOUBLE_EQ(timeline.time(2), 2.0);
  EXPECT_EQ(timeline.frames(0, 1), 2U);
}

// Two frames at each moment of the first channel, and one in all of the second.
TEST(Timeline, DropsItsFirstMoments) {
  Timeline timeline(std::vector<double>{0.0, 0.0});
  for (std::size_t moment = 0; moment < 6; ++moment) {
    timeline.append(0.5 * static_cast<double>(moment), std::vector<std::size_t>{2 * moment + 2, 1});
  }
  timeline.drop_before(4);
  EXPECT_EQ(timeline.first(), 4U);
  EXPECT_EQ(timeline.moments(), 6U);
  EXPECT_EQ(timeline.time(4), 2.0);
  EXPECT_EQ(timeline.frames(0, 5), 12U);
  EXPECT_EQ(timeline.dropped(), (std::vector<std::size_t>{8, 0})) << "the only frame is needed";
  timeline.drop_before(4);
  timeline.append(3.0, std::vector<std::size_t>{14, 2});
  timeline.drop_before(6);
  EXPECT_EQ(timeline.moments(), 7U);
  EXPECT_EQ(timeline.dropped(), (std::vector<std::size_t>{12, 1}));
}

TEST(Timeline, HasTenMomentsPerSecondWithoutTimes) {
  const Timeline timeline(Exploration{{}, {}, {channel(5)}});
  EXPECT_DOUBLE_EQ(timeline.time(4), 0.4);
}

TEST(Timeline, GathersFastFramesInStretches) {
  const Timeline timeline(Exploration{{}, {}, {channel(8192, 8192.0), channel(1)}});
  ASSERT_EQ(timeline.moments(), 16U);
  EXPECT_EQ(timeline.frames(0, 0), 512U);
  EXPECT_EQ(timeline.frames(0, 15), 8192U);
  EXPECT_NEAR(timeline.time(7), 0.5, 1e-3);
  // A single value comes at the end.
  EXPECT_EQ(timeline.frames(1, 14), 0U);
  EXPECT_EQ(timeline.frames(1, 15), 1U);
}

TEST(Timeline, EndsWithAShorterStretch) {
  const Timeline timeline(Exploration{{}, {}, {channel(1000, 1000.0)}});
  EXPECT_EQ(timeline.frames(0, timeline.moments() - 1), 1000U);
}

TEST(Timeline, HasNoMomentWithoutFrames) {
  EXPECT_EQ(Timeline(Exploration{}).moments(), 0U);
  EXPECT_EQ(Timeline(Exploration{{}, {}, {channel(0)}}).moments(), 0U);
}

TEST(Timeline, Grows) {
  Timeline timeline(std::vector<double>{0.0, 100.0});
  EXPECT_EQ(timeline.moments(), 0U);
  timeline.append(0.5, std::vector<std::size_t>{1, 50});
  timeline.append(1.5, std::vector<std::size_t>{2, 151});
  ASSERT_EQ(timeline.moments(), 2U);
  EXPECT_EQ(timeline.time(1), 1.5);
  EXPECT_EQ(timeline.frames(1, 0), 50U);
  EXPECT_EQ(timeline.frames(1, 1), 151U);
  EXPECT_EQ(timeline.rate(1), 100.0);
}

}  // namespace
}  // namespace somato::live
