#include "studies/codes/views.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

using FloatValues = std::vector<float>;

FloatValues seen(const FloatValues& frames, View view) {
  const Recording recording = seen_in(testing::frames_as_given("touch", {frames}), view);
  const auto values = recording.explorations.front().channels.front().frames.values();
  return {values.begin(), values.end()};
}

TEST(Views, SelectHalfOfTheFrames) {
  const FloatValues even{1, 2, 3, 4};
  EXPECT_EQ(seen(even, View::kWhole), even);
  EXPECT_EQ(seen(even, View::kOdd), (FloatValues{1, 3}));
  EXPECT_EQ(seen(even, View::kEven), (FloatValues{2, 4}));
  EXPECT_EQ(seen(even, View::kFirst), (FloatValues{1, 2}));
  EXPECT_EQ(seen(even, View::kSecond), (FloatValues{3, 4}));
}

TEST(Views, BothHalvesHaveTheFrameInTheMiddle) {
  EXPECT_EQ(seen({1, 2, 3}, View::kFirst), (FloatValues{1, 2}));
  EXPECT_EQ(seen({1, 2, 3}, View::kSecond), (FloatValues{2, 3}));
  EXPECT_EQ(seen({1, 2, 3}, View::kEven), (FloatValues{2}));
}

TEST(Views, ASingleFrameBelongsToAll) {
  for (const View view : kAllViews) EXPECT_EQ(seen({7}, view), (FloatValues{7}));
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

TEST(Views, ElementsAreDividedAsFramesAre) {
  const Samples vectors(Matrix<float>(1, 5, {1, 2, 3, 4, 5}));
  const auto seen = [&](View view) {
    const Samples part = seen_in(vectors, view);
    return std::vector<float>(part[0].values.begin(), part[0].values.end());
  };
  EXPECT_EQ(seen(View::kWhole), (std::vector<float>{1, 2, 3, 4, 5}));
  EXPECT_EQ(seen(View::kOdd), (std::vector<float>{1, 3, 5}));
  EXPECT_EQ(seen(View::kEven), (std::vector<float>{2, 4}));
  EXPECT_EQ(seen(View::kFirst), (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(seen(View::kSecond), (std::vector<float>{3, 4, 5}));
  EXPECT_EQ(seen_in(Samples(Matrix<float>(2, 1)), View::kEven).size(), 1U);
}

}  // namespace
}  // namespace somato
