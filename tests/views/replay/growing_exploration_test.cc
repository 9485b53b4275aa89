#include "views/replay/growing_exploration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "recordings/explorations/recording_json.h"
#include "views/session/view_json.h"

namespace somato::live {
namespace {

ChannelDescription sensor(const char* name) {
  ChannelDescription description;
  description.name = name;
  return description;
}

BodyDescription body() {
  BodyDescription body;
  body.sensors = {sensor("height"), sensor("joints"), sensor("touch")};
  body.sensors[1].element_names = {"thumb", "finger"};
  body.sensors[2].shape = {2, 2};
  return body;
}

BodyStep recorded(double time, std::vector<Matrix<float>> readings) {
  return {{time, {}, std::move(readings)}, {}, Readings::kRecorded};
}

class Growing : public ::testing::Test {
 protected:
  const Exploration& so_far() const { return *growing_.played().exploration; }
  const Timeline& timeline() const { return *growing_.played().timeline; }

  GrowingExploration growing_{3, body(), std::make_shared<Scene>()};
};

TEST_F(Growing, KnowsItsElementsBeforeItsFirstFrame) {
  const auto& channels = so_far().channels;
  EXPECT_EQ(detail::channel_json(channels[0])["elements"], (Json{"1"}));
  EXPECT_EQ(detail::channel_json(channels[0])["shape"], (Json{1}));
  EXPECT_EQ(detail::channel_json(channels[1])["elements"], (Json{"thumb", "finger"}));
  EXPECT_EQ(detail::channel_json(channels[1])["shape"], (Json{2}));
  EXPECT_EQ(detail::channel_json(channels[2])["elements"], (Json{"1", "2", "3", "4"}));
  EXPECT_EQ(growing_.played().index, 3U);
  EXPECT_FALSE(growing_.played().has_ended);
}

TEST_F(Growing, TakesAsManyElementsAsCome) {
  growing_.append(recorded(0.0, {Matrix<float>(1, 3, 7.0F), {}, {}}));
  EXPECT_EQ(so_far().channels[0].frames, Matrix<float>(1, 3, 7.0F));
}

TEST_F(Growing, AMissingReadingIsShownAsMissing) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  growing_.append(recorded(0.0, {{}, Matrix<float>(1, 2, {kNone, 7}), {}}));
  EXPECT_TRUE(std::isnan(growing_.last().state.readings[1](0, 0)));
  EXPECT_TRUE(std::isnan(shown_values(so_far().channels[1], 0.0, 1)[0]));
  EXPECT_EQ(so_far().channels[1].valid, Matrix<std::uint8_t>(1, 2, {0, 1}));
}

TEST_F(Growing, FramesWithTimesOfTheirOwnKeepThem) {
  BodyStep step = recorded(1.0, {Matrix<float>(1, 1, 9.0F), {}, Matrix<float>(3, 4, 5.0F)});
  step.state.times = {{}, {}, {0.25, 0.5, 0.75}};
  growing_.append(step);
  EXPECT_EQ(so_far().channels[0].times, std::vector<double>{1.0});
  EXPECT_EQ(so_far().channels[2].times, (std::vector<double>{0.25, 0.5, 0.75}));
  EXPECT_EQ(timeline().frames(2, 0), 3U);
}

TEST_F(Growing, HasAMomentForEachRecordedStep) {
  growing_.append({{0.25, {}, {Matrix<float>(1, 1, 9.0F), {}, {}}}, {}, Readings::kLeftOut});
  growing_.append(recorded(0.5, {Matrix<float>(1, 1, 1.0F), {}, {}}));
  growing_.append(recorded(1.0, {Matrix<float>(1, 1, 2.0F), Matrix<float>(1, 2, 3.0F), {}}));
  ASSERT_EQ(timeline().moments(), 2U);
  EXPECT_EQ(timeline().time(1), 0.75);  // from the first step
  EXPECT_EQ(timeline().frames(0, 1), 2U);
  EXPECT_EQ(timeline().frames(1, 1), 1U);
  EXPECT_EQ(timeline().frames(2, 1), 0U);
  const Channel& height = so_far().channels[0];
  EXPECT_EQ(height.frames, Matrix<float>(2, 1, std::vector<float>{1, 2}));
  EXPECT_EQ(height.times, (std::vector<double>{0.5, 1.0}));  // by the body's clock
}

TEST_F(Growing, KnowsItsLastStep) {
  const BodyStep first{{5.0, {}, {Matrix<float>(1, 1, 1.0F), {}, {}}}, {}, Readings::kLeftOut};
  EXPECT_EQ(growing_.seconds_to(first), 0.0);
  growing_.append(first);
  const BodyStep next{{5.5, {}, {{}, Matrix<float>(1, 2, 3.0F), {}}}, {}, Readings::kLeftOut};
  EXPECT_EQ(growing_.seconds_to(next), 0.5);
  growing_.append(next);
  EXPECT_EQ(growing_.last().state.time, 0.5);
  EXPECT_EQ(growing_.last().state.readings[0], Matrix<float>(1, 1, 1.0F));
  EXPECT_EQ(growing_.last().state.readings[1], Matrix<float>(1, 2, 3.0F));
}

TEST_F(Growing, KeepsWhatWasSeenAtItsMoments) {
  for (const double x : {1.0, 2.0, 3.0}) {
    BodyStep step = recorded(x, {Matrix<float>(1, 1, 0.0F), {}, {}});
    step.poses.resize(1);
    step.poses[0].position[0] = x;
    growing_.append(step);
  }
  EXPECT_EQ(growing_.scene()->poses(so_far(), 1).at(0).position[0], 2.0);
}

// Memory stays below a limit however long a body explores, and what is kept is right.
TEST_F(Growing, DropsTheOlderHalfOfItsMoments) {
  constexpr std::size_t kMost = 20000;
  std::size_t most = 0;
  for (std::size_t step = 0; step < 10000; ++step) {
    const auto x = static_cast<float>(step);
    BodyStep taken = recorded(0.5 * x, {Matrix<float>(1, 1, x), Matrix<float>(1, 2, x), {}});
    taken.poses.resize(1);
    taken.poses[0].position[0] = x;
    growing_.append(taken);
    if (growing_.bytes() > kMost) growing_.drop_half();
    most = std::max(most, growing_.bytes());
  }
  EXPECT_LE(most, kMost);
  EXPECT_GE(growing_.bytes(), kMost / 2 - 100);
  EXPECT_EQ(timeline().moments(), 10000U);
  const std::size_t first = timeline().first();
  EXPECT_GT(first, 9000U);
  for (const std::size_t moment : {first, std::size_t{9999}}) {
    EXPECT_EQ(timeline().time(moment), 0.5 * static_cast<double>(moment));
    const std::size_t row = timeline().frames(1, moment) - timeline().dropped(1) - 1;
    EXPECT_EQ(so_far().channels[1].frames(row, 1), static_cast<float>(moment));
    EXPECT_EQ(growing_.scene()->poses(so_far(), row).at(0).position[0],
              static_cast<double>(moment));
  }
  const std::size_t before = growing_.bytes();
  while (timeline().moments() - timeline().first() > 1) growing_.drop_half();
  growing_.drop_half();
  EXPECT_EQ(timeline().first(), 9999U) << "the last moment is kept";
  EXPECT_LT(growing_.bytes(), before);
}

}  // namespace
}  // namespace somato::live
