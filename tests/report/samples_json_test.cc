#include "report/samples_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "support/json_schema.h"

namespace somato {
namespace {

using detail::Evidence;
using Json = nlohmann::ordered_json;

// A part of a system of the report, checked by its schema.
Json checked(Json part, const std::string& name) {
  EXPECT_TRUE(testing::fits_schema(part, "report.json#/$defs/SystemReport/properties/" + name));
  return part;
}
Json samples_of(const Evidence& evidence) {
  return checked(detail::samples_json(evidence), "samples");
}
Json things_of(const Evidence& evidence, const std::vector<ReportThing>& known) {
  return checked(detail::things_json(evidence, known), "things");
}
Json moments_of(const Evidence& evidence) {
  return checked(detail::moments_json(evidence), "moments");
}

Channel channel(const std::string& name, std::size_t frames, std::size_t elements, double rate) {
  Matrix<float> values(frames, elements);
  for (std::size_t i = 0; i < values.values().size(); ++i) {
    values.values()[i] = static_cast<float>(i % 7);
  }
  return {name, "u", {}, std::move(values), {}, rate, {}, {}};
}

class SamplesJson : public ::testing::Test {
 protected:
  SamplesJson() {
    results_.protocols.push_back({"train_is_test", "", "object", 3, {}, {}});
    evidence_.part = &results_;
    evidence_.explorations = {0, 1, 2};
    for (const std::string name : {"ball", "ball", "cube"}) {
      recording_->explorations.push_back({{{"object", name}, {"material", "wood"}}, "", {}});
    }
    evidence_.recording = recording_;
  }

  Exploration& exploration(std::size_t i) { return recording_->explorations[i]; }

  PartResults results_;
  std::shared_ptr<Recording> recording_ = std::make_shared<Recording>();
  Evidence evidence_;
};

TEST_F(SamplesJson, LabelsStandInTheOrderOfTheSamples) {
  evidence_.explorations = {2, 0};
  EXPECT_EQ(samples_of(evidence_)[0]["object"], "cube");
  EXPECT_EQ(samples_of(evidence_)[1]["material"], "wood");
  evidence_.recording = nullptr;
  EXPECT_TRUE(samples_of(evidence_).is_null());
}

TEST_F(SamplesJson, AThingThatIsKnownIsCompletedUnlessItContradicts) {
  using Size = std::array<double, 3>;
  const ReportThing steel{"ball", "sphere", Size{1, 1, 1}, 0, "metal", "hard", {}, 2.0};
  const ReportThing wooden{"ball", "sphere", Size{7, 7, 7}, 0, "wood", "hard", Size{1, 0, 0}, 3.0};
  const Json things = things_of(evidence_, {steel, wooden});
  ASSERT_EQ(things.size(), 2U);
  EXPECT_EQ(things[0]["size"], Json::array({7.0, 7.0, 7.0}));
  EXPECT_EQ(things[0]["colour"], Json::array({1.0, 0.0, 0.0}));
  EXPECT_EQ(things[0]["mass"], 3.0);
  EXPECT_EQ(things[1]["name"], "cube");
  EXPECT_EQ(things[1]["material"], "wood");
  EXPECT_TRUE(things[1]["shape"].is_null());
  EXPECT_TRUE(things[1]["size"].is_null());
}

TEST_F(SamplesJson, WithoutARecordingThingsAreTheClasses) {
  evidence_.recording = nullptr;
  results_.protocols[0].runs = {{1, {0, 0, 0}, {"b", "a", "b"}, {"b", "a", "b"}, {}}};
  const Json things = things_of(evidence_, {});
  ASSERT_EQ(things.size(), 2U);
  EXPECT_EQ(things[0]["name"], "b");
  results_.protocols[0].label = "shape";
  EXPECT_EQ(things_of(evidence_, {}), Json::array());
}

TEST_F(SamplesJson, TheMomentIsThatOfMostTouch) {
  for (std::size_t i = 0; i < 3; ++i) {
    Channel touch = channel("touch", 10, 2, 10.0);
    for (float& value : touch.frames.values()) value = 1.0F;
    touch.frames(6, 1) = 5.0F;
    touch.frames(8, 0) = 5.0F;  // as much, and later
    exploration(i).channels = {channel("joints", 10, 3, 0.0), touch, channel("sound", 100, 1, 100),
                               channel("odd", 4, 1, 0.0)};
  }
  const Json moments = moments_of(evidence_);
  ASSERT_EQ(moments.size(), 2U);  // one exploration a thing
  EXPECT_EQ(moments[1]["labels"]["object"], "cube");
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

TEST_F(SamplesJson, WithoutTouchTheMomentIsTheLast) {
  exploration(0).channels = {channel("joints", 9, 3, 0.0)};
  evidence_.explorations = {0};
  EXPECT_EQ(moments_of(evidence_)[0]["channels"][0]["frame"], 8);
}

TEST_F(SamplesJson, AtMost200FramesFromFirstToLastAreShown) {
  exploration(0).channels = {channel("sound", 44100, 1, 44100), channel("skin", 5, 65, 1.0),
                             channel("one", 1, 2, 0.0)};
  evidence_.explorations = {0};
  const Json channels = moments_of(evidence_)[0]["channels"];
  EXPECT_EQ(channels[0]["times"].size(), 200U);
  EXPECT_EQ(channels[0]["times"][0], 0);
  EXPECT_NEAR(channels[0]["times"][199].get<double>(), 44099.0 / 44100.0, 1e-5);
  EXPECT_EQ(channels[0]["series"].size(), 200U);
  EXPECT_EQ(channels[0]["series"][199][0], 44099 % 7);
  EXPECT_EQ(channels[1]["series"], Json::array());
  EXPECT_EQ(channels[1]["values"].size(), 65U);
  EXPECT_EQ(channels[2]["times"].size(), 1U);
}

TEST_F(SamplesJson, TheMomentIsAmongTheFramesShown) {
  evidence_.explorations = {0};
  for (const std::size_t moment : {0U, 1U, 998U, 999U, 500U, 501U, 502U, 503U, 504U, 505U}) {
    Channel touch = channel("touch", 1000, 1, 1.0);
    for (float& value : touch.frames.values()) value = 0.0F;
    touch.frames(moment, 0) = 1.0F;
    exploration(0).channels = {touch};
    const Json shown = moments_of(evidence_)[0]["channels"][0];
    ASSERT_EQ(shown["times"].size(), 200U);
    EXPECT_EQ(shown["frame"], moment);
    EXPECT_EQ(shown["time"], moment);
    EXPECT_EQ(shown["times"][0], 0);
    EXPECT_EQ(shown["times"][199], 999);
    const auto times = shown["times"].get<std::vector<double>>();
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_EQ(std::count(times.begin(), times.end(), static_cast<double>(moment)), 1) << moment;
  }
}

}  // namespace
}  // namespace somato
