#include "studies/inference/recording_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "studies/inference/touches.h"

namespace somato {
namespace {

using test::synthetic_recording;

std::vector<std::size_t> first_rows(std::size_t count) {
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::size_t number_of(const ComparedTouch& compared, const Statistic& wanted) {
  const auto names = statistic_names(compared);
  const auto found = std::find(names.begin(), names.end(), wanted);
  EXPECT_NE(found, names.end()) << wanted.channel << " " << wanted.measure << " " << wanted.thing;
  return static_cast<std::size_t>(found - names.begin());
}

double mean_touch(const Exploration& exploration) {
  double sum = 0.0;
  for (const float value : exploration.channels[0].frames.values()) sum += value;
  return sum / 24.0;
}

double mean_sound(const Exploration& exploration) {
  double sum = 0.0;
  for (const float value : exploration.channels[1].frames.values()) sum += value;
  return sum / 64.0;
}

TEST(RecordingStatistics, AreMeansOverTheExplorationsOfEachThing) {
  const Recording real = synthetic_recording({}, 2, 4, 1);
  const ComparedTouch compared = compared_touch(real, synthetic_recording({}, 3, 2, 2), {}).value();
  EXPECT_EQ(compared.label, "object");
  EXPECT_EQ(compared.things, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(compared.channels.size(), 2U);
  EXPECT_EQ(compared.channels[0].spectrum_frames, 0U) << "its rate is unknown";
  EXPECT_EQ(compared.channels[1].spectrum_frames, 64U);
  const TouchFeatures touch = touch_features(compared, real).value();
  const std::vector<double> statistics = statistics_of(compared, touch, first_rows(8));
  ASSERT_EQ(statistics.size(), statistic_names(compared).size());
  std::vector<double> touches;
  std::vector<double> sounds;
  for (const Exploration& exploration : real.explorations) {
    touches.push_back(mean_touch(exploration));
    sounds.push_back(mean_sound(exploration));
  }
  const auto mean = [](const std::vector<double>& values, std::size_t from, std::size_t count) {
    double sum = 0.0;
    for (std::size_t i = from; i < from + count; ++i) sum += values[i];
    return sum / static_cast<double>(count);
  };
  EXPECT_NEAR(statistics[number_of(compared, {"touch", "mean", "b"})], mean(touches, 4, 4), 1e-9);
  double squares = 0.0;
  double squares_of_a = 0.0;
  double products = 0.0;
  double squares_a = 0.0;
  double squares_b = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const double own = mean(touches, i < 4 ? 0 : 4, 4);
    squares += (touches[i] - own) * (touches[i] - own);
    if (i < 4) squares_of_a += (touches[i] - own) * (touches[i] - own);
    const double a = touches[i] - mean(touches, 0, 8);
    const double b = sounds[i] - mean(sounds, 0, 8);
    products += a * b;
    squares_a += a * a;
    squares_b += b * b;
  }
  EXPECT_NEAR(
      statistics[number_of(compared, {"touch", "spread between explorations of a thing", ""})],
      std::sqrt(squares / 6.0), 1e-9);
  EXPECT_NEAR(
      statistics[number_of(compared, {"touch, sound", "correlation between explorations", ""})],
      products / std::sqrt(squares_a * squares_b), 1e-9);
  // The scale of a mean is the standard deviation between explorations.
  const std::vector<double> scales = statistic_scales(compared, touch, first_rows(8));
  const std::size_t a = number_of(compared, {"touch", "mean", "a"});
  const std::size_t b = number_of(compared, {"touch", "mean", "b"});
  EXPECT_NEAR(scales[a], std::sqrt(squares_of_a / 3.0), 1e-9);
  const std::vector<double> of_one = statistic_scales(compared, touch, {0, 1, 2, 3, 4});
  EXPECT_NEAR(of_one[a], scales[a], 1e-9);
  EXPECT_NEAR(of_one[b], scales[a], 1e-9) << "b was explored once";
}

TEST(RecordingStatistics, OfDifferentThingsAreOfAllTogether) {
  Recording simulated = synthetic_recording({}, 1, 2, 2);
  for (Exploration& exploration : simulated.explorations) exploration.labels[0].value = "other";
  const Recording real = synthetic_recording({}, 2, 4, 1);
  const ComparedTouch compared = compared_touch(real, simulated, {}).value();
  EXPECT_TRUE(compared.things.empty());
  const TouchFeatures touch = touch_features(compared, real).value();
  EXPECT_EQ(touch.same, (std::vector<std::size_t>{0, 0, 0, 0, 1, 1, 1, 1}));
  double sum = 0.0;
  for (const Exploration& exploration : real.explorations) sum += mean_touch(exploration) / 8.0;
  EXPECT_NEAR(statistics_of(compared, touch, first_rows(8))[kMeanFeature], sum, 1e-9);
}

TEST(RecordingStatistics, DoNotRequireLabels) {
  Recording real = synthetic_recording({}, 1, 4, 1);
  for (Exploration& exploration : real.explorations) exploration.labels.clear();
  const ComparedTouch compared = compared_touch(real, synthetic_recording({}, 1, 2, 2), {}).value();
  EXPECT_EQ(compared.label, "");
  EXPECT_TRUE(touch_features(compared, real));
  const auto missing =
      compared_touch(real, synthetic_recording({}, 1, 2, 2), {.label = "object", .channels = {}});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kUsage);
}

TEST(RecordingStatistics, NameTheChannelsThatAreNotCompared) {
  const Recording simulated = synthetic_recording({}, 2, 2, 2);
  Recording real = synthetic_recording({}, 2, 2, 1);
  for (Exploration& exploration : real.explorations) {
    exploration.channels[0].unit = "counts";
    exploration.channels.push_back({"wrist", "", {}, Matrix<float>(8, 1), {}, 0.0, {}, {}});
  }
  const ComparedTouch compared = compared_touch(real, simulated, {}).value();
  ASSERT_EQ(compared.channels.size(), 1U);
  EXPECT_EQ(compared.channels[0].name, "sound");
  ASSERT_EQ(compared.ignored.size(), 2U);
  EXPECT_EQ(compared.ignored[0].reason, "its unit is N in the simulation and counts here");
  EXPECT_EQ(compared.ignored[1].reason, "the simulated body does not have it");
  for (Exploration& exploration : real.explorations) {
    exploration.channels.pop_back();
    exploration.channels[0].unit = "";
    exploration.channels[0].shape = {3, 1};
    exploration.channels[1].name = "noise";
  }
  const auto none = compared_touch(real, simulated, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::kData);
  for (const char* said : {"'touch': it has another shape", "'noise': the simulated body",
                           "'sound': the given recording"}) {
    EXPECT_NE(none.error().what.find(said), std::string::npos) << none.error().what;
  }
  EXPECT_EQ(compared_touch(real, simulated, {.label = "", .channels = {"tuch"}}).error().kind,
            ErrorKind::kUsage);
}

TEST(RecordingStatistics, HaveNoScaleWhereTheChannelIsConstant) {
  Recording real = synthetic_recording({}, 2, 3, 1);
  for (Exploration& exploration : real.explorations) {
    for (float& value : exploration.channels[0].frames.values()) value = 4.0F;
  }
  const ComparedTouch compared = compared_touch(real, real, {}).value();
  const TouchFeatures touch = touch_features(compared, real).value();
  const std::vector<double> scales = statistic_scales(compared, touch, first_rows(6));
  EXPECT_EQ(scales[number_of(compared, {"touch", "mean", "a"})], 0.0);
  EXPECT_GT(scales[number_of(compared, {"sound", "mean", "a"})], 0.0);
  EXPECT_TRUE(std::isnan(
      statistic_scales(compared, touch, {0, 3})[number_of(compared, {"sound", "mean", "a"})]))
      << "one exploration of each thing";
}

// Equal explorations: a hundredth of the spread of all values.
TEST(RecordingStatistics, HaveALeastScale) {
  Recording real = synthetic_recording({}, 1, 1, 1);
  for (int i = 0; i < 3; ++i) real.explorations.push_back(real.explorations[0]);
  const ComparedTouch compared = compared_touch(real, real, {}).value();
  const TouchFeatures touch = touch_features(compared, real).value();
  const std::vector<double> scales = statistic_scales(compared, touch, first_rows(4));
  EXPECT_NEAR(scales[number_of(compared, {"touch", "mean", "a"})],
              0.01 * touch.features(0, kSpreadFeature), 1e-12);
  EXPECT_EQ(scales[number_of(compared, {"touch", "correlation of elements", "a"})], 0.01);
}

TEST(RecordingStatistics, AreOfBlocksOfEachThing) {
  const Recording real = synthetic_recording({}, 2, 3, 1);
  const ComparedTouch compared = compared_touch(real, real, {}).value();
  TouchFeatures touch = touch_features(compared, real).value();
  auto halves = halves_of(touch);
  EXPECT_EQ(halves.first, (std::vector<std::size_t>{0, 1, 3, 4}));
  EXPECT_EQ(halves.second, (std::vector<std::size_t>{2, 5}));
  touch.same = {0, 1, 2, 3, 4, 5};
  halves = halves_of(touch);
  EXPECT_EQ(halves.first, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(halves.second, (std::vector<std::size_t>{3, 4, 5}));
}

}  // namespace
}  // namespace somato
