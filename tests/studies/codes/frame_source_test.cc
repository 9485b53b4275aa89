#include "studies/codes/frame_source.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;
using FloatValues = std::vector<float>;

FloatValues values_of(const Recording& recording, std::size_t exploration) {
  const auto values = recording.explorations[exploration].channels.front().frames.values();
  return {values.begin(), values.end()};
}

// At rest for `start` frames, then pressed for 10.
FloatValues pressed_after(std::size_t start) {
  FloatValues frames(start, 2.0F);
  for (int i = 0; i < 10; ++i) frames.push_back(12.0F);
  return frames;
}

TEST(FrameSource, ModulesAreNamedAfterTheirChannelsIfPossible) {
  EXPECT_EQ(module_names({"joints", "touch", "touch_change"}),
            (Names{"joints", "touch", "touch_change"}));
  EXPECT_EQ(module_names({"map", "mean_of_x", "", "a b", "channel_1", "\n"}),
            (Names{"channel_1", "channel_2", "channel_3", "channel_4", "channel_5", "channel_6"}));
  EXPECT_EQ(module_names({"touch", "touch"}), (Names{"touch", "channel_2"}));
}

TEST(FrameSource, OutputsTheFramesOfAChannel) {
  const Recording recording = testing::frames_as_given("touch", {{1, 2}, {3}});
  const auto source = channel_source("touch", recording, 0);
  const Recording frames = frames_of(recording, source, 1).value();
  EXPECT_EQ(values_of(frames, 0), (FloatValues{1, 2}));
  EXPECT_EQ(values_of(frames, 1), (FloatValues{3}));
}

TEST(FrameSource, MissingValuesAreReplacedByThePrecedingOnes) {
  Recording recording = testing::frames_as_given("touch", {{4, 0, 6}});
  Channel& channel = recording.explorations[0].channels[0];
  channel.valid = Matrix<std::uint8_t>(3, 1, {1, 0, 1});
  const Recording frames = frames_of(recording, channel_source("touch", recording, 0), 1).value();
  EXPECT_EQ(values_of(frames, 0), (FloatValues{4, 4, 6}));
}

TEST(FrameSource, MissingValuesWithoutAPrecedingOneAreReplacedByTheMean) {
  Recording recording = testing::frames_as_given("touch", {{4, 6}, {0, 8}});
  recording.explorations[1].channels[0].valid = Matrix<std::uint8_t>(2, 1, {0, 1});
  const Recording frames = frames_of(recording, channel_source("touch", recording, 0), 1).value();
  EXPECT_EQ(values_of(frames, 0), (FloatValues{4, 6}));
  EXPECT_EQ(values_of(frames, 1), (FloatValues{6, 8}));
}

TEST(FrameSource, MissingValuesOfSingleFramesAreReplacedByTheMeanOfTheirElement) {
  Recording recording = testing::frames_as_given("touch", {{0}, {3}, {8}});
  recording.explorations[0].channels[0].valid = Matrix<std::uint8_t>(1, 1, 0);
  const FrameSource source = channel_source("touch", recording, 0);
  EXPECT_FALSE(source.modules[0].settings.find("invalid"));
  EXPECT_EQ(values_of(frames_of(recording, source, 1).value(), 0), FloatValues(1, 5.5F));
}

TEST(FrameSource, FindsAnOnsetThatVaries) {
  const Recording frames =
      testing::frames_as_given("touch", {pressed_after(3), pressed_after(5), pressed_after(9)});
  const auto onset = find_varying_onset(frames);
  ASSERT_TRUE(onset.has_value());
  EXPECT_EQ(onset->threshold, 2.0);  // a fifth of 10
  EXPECT_EQ(onset->length, 10U);
  const auto source = from_onset(channel_source("touch", frames, 0), *onset);
  EXPECT_EQ(values_of(frames_of(frames, source, 1).value(), 2), FloatValues(10, 12.0F));
}

TEST(FrameSource, AnOnsetThatDoesNotVaryOrIsMissingIsNotUsed) {
  EXPECT_FALSE(
      find_varying_onset(testing::frames_as_given("touch", {pressed_after(5), pressed_after(5)}))
          .has_value());
  EXPECT_FALSE(
      find_varying_onset(testing::frames_as_given(
                             "touch", {pressed_after(3), pressed_after(9), FloatValues(15, 2.0F)}))
          .has_value());
  EXPECT_FALSE(find_varying_onset(testing::frames_as_given("touch", {{1}, {2}})).has_value());
}

}  // namespace
}  // namespace somato
