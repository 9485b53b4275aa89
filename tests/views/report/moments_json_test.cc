#include "views/report/moments_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/support/json_schema.h"
#include "views/report/three_explorations.h"
#include "views/support/unpacked_json.h"

namespace somato {
namespace {

using detail::Evidence;
using testing::unpacked;
using Json = nlohmann::ordered_json;

// The listed readings of all samples, checked by their schema.
Json moments_of(const Evidence& evidence) {
  detail::Moments moments;
  EXPECT_TRUE(testing::fits_schema(moments.numbers(evidence, true),
                                   "report.json#/$defs/SystemReport/properties/moments"));
  EXPECT_TRUE(
      testing::fits_schema(moments.list(), "report.json#/$defs/ReportData/properties/moments"));
  return moments.list();
}

Channel channel(const std::string& name, std::size_t frames, std::size_t elements, double rate) {
  Matrix<float> values(frames, elements);
  for (std::size_t i = 0; i < values.values().size(); ++i) {
    values.values()[i] = static_cast<float>(i % 7);
  }
  return {name, "u", {}, std::move(values), {}, rate, {}, {}};
}

class MomentsJson : public testing::ThreeExplorations {};

TEST_F(MomentsJson, TheMomentIsThatOfMostTouch) {
  for (std::size_t i = 0; i < 3; ++i) {
    Channel touch = channel("touch", 10, 2, 10.0);
    for (float& value : touch.frames.values()) value = 1.0F;
    touch.frames(6, 1) = 5.0F;
    touch.frames(8, 0) = 5.0F;  // as much, and later
    exploration(i).channels = {channel("joints", 10, 3, 0.0), touch, channel("sound", 100, 1, 100),
                               channel("odd", 4, 1, 0.0)};
  }
  const Json moments = moments_of(evidence_);
  ASSERT_EQ(moments.size(), 3U);  // of each sample
  EXPECT_EQ(moments[2]["labels"]["object"], "cube");
  const Json& channels = moments[0]["channels"];
  EXPECT_EQ(channels[0]["frame"], 6);  // as many frames as touch
  EXPECT_EQ(channels[0]["values"], Json::array({4, 5, 6}));
  EXPECT_EQ(channels[1]["frame"], 6);
  EXPECT_EQ(channels[1]["values"], Json::array({1, 5}));
  EXPECT_EQ(channels[2]["frame"], 60);  // 0.6 s
  EXPECT_EQ(channels[2]["time"], 0.6);
  EXPECT_EQ(channels[3]["frame"], 3);  // the time is unknown: the last frame
  EXPECT_EQ(channels[0]["channel"]["elements"], Json::array({"1", "2", "3"}));
  EXPECT_EQ(channels[0]["channel"]["unit"], "u");
}

TEST_F(MomentsJson, WithoutTouchTheMomentIsTheLast) {
  exploration(0).channels = {channel("joints", 9, 3, 0.0)};
  evidence_.explorations = {0};
  EXPECT_EQ(moments_of(evidence_)[0]["channels"][0]["frame"], 8);
}

TEST_F(MomentsJson, AtMost200FramesFromFirstToLastAreShown) {
  exploration(0).channels = {channel("sound", 44100, 1, 44100), channel("skin", 5, 65, 1.0),
                             channel("one", 1, 2, 0.0)};
  evidence_.explorations = {0};
  const Json channels = moments_of(evidence_)[0]["channels"];
  const auto times = unpacked(channels[0]["times"]);
  ASSERT_EQ(times.size(), 200U);
  EXPECT_EQ(times[0], 0.0);
  EXPECT_NEAR(times[199], 44099.0 / 44100.0, 1e-5);
  const auto series = unpacked(channels[0]["series"]);
  ASSERT_EQ(series.size(), 200U);
  EXPECT_NEAR(series[199], 44099 % 7, 6.0 / 508.0);
  EXPECT_TRUE(unpacked(channels[1]["series"]).empty());
  EXPECT_EQ(channels[1]["values"].size(), 65U);
  EXPECT_EQ(unpacked(channels[2]["times"]).size(), 1U);
}

TEST_F(MomentsJson, TheMomentIsAmongTheFramesShown) {
  evidence_.explorations = {0};
  for (const std::size_t moment : {0U, 1U, 998U, 999U, 500U, 501U, 502U, 503U, 504U, 505U}) {
    Channel touch = channel("touch", 1000, 1, 1.0);
    for (float& value : touch.frames.values()) value = 0.0F;
    touch.frames(moment, 0) = 1.0F;
    exploration(0).channels = {touch};
    const Json shown = moments_of(evidence_)[0]["channels"][0];
    auto times = unpacked(shown["times"]);
    ASSERT_EQ(times.size(), 200U);
    for (double& time : times) time = std::round(time);  // whole seconds, with 16 bits
    EXPECT_EQ(shown["frame"], moment);
    EXPECT_EQ(shown["time"], moment);
    EXPECT_EQ(times[0], 0.0);
    EXPECT_EQ(times[199], 999.0);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_EQ(std::count(times.begin(), times.end(), static_cast<double>(moment)), 1) << moment;
  }
}

TEST_F(MomentsJson, AnExplorationIsListedOnceForAllSystems) {
  for (std::size_t i = 0; i < 3; ++i) exploration(i).channels = {channel("joints", 9, 3, 0.0)};
  detail::Moments moments;
  evidence_.explorations = {2, 0};
  EXPECT_EQ(moments.numbers(evidence_, true), Json::array({0, 1}));
  evidence_.explorations = {0, 1, 2};
  EXPECT_EQ(moments.numbers(evidence_, false), Json::array({1, nullptr, 0}));
  EXPECT_EQ(moments.numbers(evidence_, true), Json::array({1, 2, 0}));
  EXPECT_EQ(moments.list().size(), 3U);
  results_.recordings[0].hash = "another";
  EXPECT_EQ(moments.numbers(evidence_, false), Json::array({nullptr, nullptr, nullptr}));
  evidence_.recording = nullptr;
  EXPECT_EQ(moments.numbers(evidence_, true), Json::array());
}

TEST_F(MomentsJson, OfTooManyNumbersOnlyTheFirstExplorationOfEachThingIsListed) {
  // 3 explorations of 2600 elements: 38 frames of each would be 300000 numbers.
  for (std::size_t i = 0; i < 3; ++i) {
    exploration(i).channels.clear();
    for (int k = 0; k < 52; ++k) {
      exploration(i).channels.push_back(channel("c" + std::to_string(k), 300, 50, 10.0));
    }
  }
  detail::Moments moments;
  EXPECT_EQ(moments.numbers(evidence_, true), Json::array({0, nullptr, 1}));
  EXPECT_EQ(unpacked(moments.list()[0]["channels"][0]["times"]).size(), 200U);
  // With half of the elements 76 frames of each are shown.
  for (std::size_t i = 0; i < 3; ++i) exploration(i).channels.resize(26);
  detail::Moments fewer;
  EXPECT_EQ(fewer.numbers(evidence_, true), Json::array({0, 1, 2}));
  EXPECT_EQ(unpacked(fewer.list()[0]["channels"][0]["times"]).size(), 76U);
}

}  // namespace
}  // namespace somato
