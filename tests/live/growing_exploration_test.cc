#include "live/growing_exploration.h"

#include <gtest/gtest.h>

#include "live/view_json.h"

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

TEST(GrowingExploration, KnowsItsElementsBeforeItsFirstFrame) {
  const GrowingExploration growing(body());
  const auto& channels = growing.so_far().channels;
  EXPECT_EQ(channel_json(channels[0])["elements"], (Json{"1"}));
  EXPECT_EQ(channel_json(channels[0])["shape"], (Json{1}));
  EXPECT_EQ(channel_json(channels[1])["elements"], (Json{"thumb", "finger"}));
  EXPECT_EQ(channel_json(channels[1])["shape"], (Json{2}));
  EXPECT_EQ(channel_json(channels[2])["elements"], (Json{"1", "2", "3", "4"}));
}

TEST(GrowingExploration, TakesAsManyElementsAsCome) {
  GrowingExploration growing(body());
  growing.append({0.0, {}, {Matrix<float>(1, 3, 7.0F), {}, {}}});
  EXPECT_EQ(growing.so_far().channels[0].frames, Matrix<float>(1, 3, 7.0F));
}

TEST(GrowingExploration, KeepsTheFramesOfEachMoment) {
  GrowingExploration growing(body());
  growing.append({0.5, {}, {Matrix<float>(1, 1, 1.0F), {}, {}}});
  growing.append({1.0, {}, {Matrix<float>(1, 1, 2.0F), Matrix<float>(1, 2, 3.0F), {}}});
  ASSERT_EQ(growing.moments(), 2U);
  EXPECT_EQ(growing.moment(1).time, 1.0);
  EXPECT_EQ(growing.moment(1).frames, (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_EQ(growing.frames(), growing.moment(1).frames);
  const Channel& height = growing.so_far().channels[0];
  EXPECT_EQ(height.frames, Matrix<float>(2, 1, std::vector<float>{1, 2}));
  EXPECT_EQ(height.times, (std::vector<double>{0.5, 1.0}));
}

}  // namespace
}  // namespace somato::live
