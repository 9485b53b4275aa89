#include "suggestion/views.h"

#include <gtest/gtest.h>

#include "support/made_senses.h"

namespace somato {
namespace {

using Values = std::vector<float>;

Values seen(const Values& frames, View view) {
  const Recording recording = seen_in(testing::frames_as_given("touch", {frames}), view);
  const auto values = recording.explorations.front().channels.front().frames.values();
  return {values.begin(), values.end()};
}

TEST(Views, SelectHalfOfTheFrames) {
  const Values even{1, 2, 3, 4};
  EXPECT_EQ(seen(even, View::kWhole), even);
  EXPECT_EQ(seen(even, View::kOdd), (Values{1, 3}));
  EXPECT_EQ(seen(even, View::kEven), (Values{2, 4}));
  EXPECT_EQ(seen(even, View::kFirst), (Values{1, 2}));
  EXPECT_EQ(seen(even, View::kSecond), (Values{3, 4}));
}

TEST(Views, BothHalvesHaveTheFrameInTheMiddle) {
  EXPECT_EQ(seen({1, 2, 3}, View::kFirst), (Values{1, 2}));
  EXPECT_EQ(seen({1, 2, 3}, View::kSecond), (Values{2, 3}));
  EXPECT_EQ(seen({1, 2, 3}, View::kEven), (Values{2}));
}

TEST(Views, ASingleFrameBelongsToAll) {
  for (const View view : kAllViews) EXPECT_EQ(seen({7}, view), (Values{7}));
}

TEST(Views, KeepTheRateAndRemoveLabelsAndTimes) {
  Recording recording = testing::frames_as_given("touch", {{1, 2, 3, 4}});
  recording.explorations.front().labels = {{"object", "cup"}};
  recording.explorations.front().channels.front().times = {0.0, 0.1, 0.2, 0.3};
  const Exploration half = seen_in(recording, View::kOdd).explorations.front();
  EXPECT_TRUE(half.labels.empty());
  EXPECT_TRUE(half.channels.front().times.empty());
  EXPECT_NEAR(half.channels.front().rate, 10.0, 1e-9);
}

}  // namespace
}  // namespace somato
