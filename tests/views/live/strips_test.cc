#include "views/live/strips.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/support/json_schema.h"
#include "systems/support/systems.h"
#include "views/replay/growing_exploration.h"

namespace somato::live {
namespace {

using nlohmann::json;

Channel channel(const std::string& name, Matrix<float> frames, double rate = 0.0) {
  Channel made;
  made.name = name;
  made.frames = std::move(frames);
  made.rate = rate;
  return made;
}

Matrix<float> counted(std::size_t frames, std::size_t elements) {
  Matrix<float> made(frames, elements);
  float number = 0.0F;
  for (float& value : made.values()) value = number++;
  return made;
}

Strips strips_of_all(const Exploration& exploration, std::size_t index = 0) {
  return strips_of({index, &exploration, std::make_shared<Timeline>(exploration), nullptr});
}

// The strips as text, checked by their schema.
std::string checked_text(const Strips& strips) {
  std::string text = strips_text(strips);
  EXPECT_TRUE(testing::text_fits_schema(text, "view.json#/$defs/Strips"));
  return text;
}

TEST(Strips, AreInterruptedWhereValuesAreMissing) {
  Exploration exploration;
  exploration.channels = {channel("touch", counted(2, 2), 10.0)};
  exploration.channels[0].valid = Matrix<std::uint8_t>(2, 2, {1, 1, 0, 1});
  const json strips = json::parse(checked_text(strips_of_all(exploration)));
  EXPECT_EQ(strips["channels"]["touch"], json::parse("[[0,1],[null,3]]"));
}

TEST(Strips, AreTheRecordingFrameByFrame) {
  const Recording recording = testing::hand_recording(3, 1);
  for (std::size_t number = 0; number < 3; ++number) {
    Exploration exploration = recording.explorations[number];
    exploration.channels.pop_back();  // the sound
    const Strips strips = strips_of_all(exploration, number);
    EXPECT_EQ(strips.exploration, number);
    ASSERT_EQ(strips.channels.size(), exploration.channels.size());
    for (std::size_t i = 0; i < strips.channels.size(); ++i) {
      const Channel& expected = exploration.channels[i];
      EXPECT_EQ(strips.channels[i].name, expected.name);
      ASSERT_EQ(strips.channels[i].values.size(), expected.frames.rows());
      for (std::size_t frame = 0; frame < expected.frames.rows(); ++frame) {
        const auto row = expected.frames.row(frame);
        EXPECT_EQ(strips.channels[i].values[frame], std::vector<float>(row.begin(), row.end()));
        EXPECT_EQ(strips.frame[frame], frame);
      }
    }
  }
}

TEST(Strips, LeaveOutWhatComesInStretches) {
  const Strips strips = strips_of_all(
      {{},
       {},
       {channel("sound", counted(8192, 1), 8192.0), channel("touch", counted(20, 3), 10.0)}});
  ASSERT_EQ(strips.channels.size(), 1U);
  EXPECT_EQ(strips.channels[0].name, "touch");
  ASSERT_EQ(strips.frame.size(), 16U);
  EXPECT_EQ(strips.channels[0].values[15], (std::vector<float>{57, 58, 59}));
}

TEST(Strips, ChooseEvenlyFromALongExploration) {
  const Strips strips = strips_of_all({{}, {}, {channel("touch", counted(100000, 1))}});
  ASSERT_EQ(strips.frame.size(), 600U);
  EXPECT_EQ(strips.frames, 100000U);
  EXPECT_EQ(strips.frame.back(), 99999U);
  std::size_t before = 0;
  for (std::size_t i = 0; i < 600; ++i) {
    EXPECT_LE(strips.frame[i] - before, 167U);
    before = strips.frame[i];
    EXPECT_EQ(strips.channels[0].values[i], (std::vector<float>{static_cast<float>(before)}));
    EXPECT_DOUBLE_EQ(strips.time[i], 0.1 * static_cast<double>(before));
  }
}

TEST(Strips, OfManyElementsHaveFewerMoments) {
  const auto moments = [](std::size_t elements) {
    return strips_of_all({{}, {}, {channel("touch", counted(700, elements))}}).frame;
  };
  EXPECT_EQ(moments(1999).size(), 100U);
  EXPECT_EQ(moments(300000), (std::vector<std::size_t>{699}));
}

TEST(Strips, OfNothingAreEmpty) {
  const Strips strips = strips_of_all({{}, {}, {channel("touch", {})}});
  EXPECT_TRUE(strips.frame.empty());
  EXPECT_EQ(checked_text(strips),
            R"({"exploration":0,"frames":0,"frame":[],"time":[],"channels":{"touch":[]}})");
}

BodyDescription body_of_strips() {
  BodyDescription body;
  body.sensors.resize(2);
  body.sensors[0].name = "height";
  body.sensors[1].name = "touch";
  body.sensors[1].shape = {2, 2};
  return body;
}

TEST(Strips, TellWhatABodyHasFeltSoFar) {
  GrowingExploration growing(2, body_of_strips(), std::make_shared<Scene>());
  growing.append({{7.0, {}, {counted(1, 1), {}}}, {}, Readings::kLeftOut});
  growing.append({{7.5, {}, {counted(1, 1), {}}}, {}, Readings::kRecorded});
  growing.append({{8.0, {}, {counted(1, 1), counted(1, 4)}}, {}, Readings::kRecorded});
  const json strips = json::parse(checked_text(strips_of(growing.played())));
  EXPECT_EQ(strips["exploration"], 2);
  EXPECT_EQ(strips["frames"], nullptr);
  EXPECT_EQ(strips["frame"], (json{0, 1}));
  EXPECT_EQ(strips["time"], (json{0.5, 1.0}));
  EXPECT_EQ(strips["channels"]["height"], json::parse("[[0],[0]]"));
  EXPECT_EQ(strips["channels"]["touch"], json::parse("[[],[0,1,2,3]]"));
}

TEST(Strips, WriteWhatIsNotFiniteAsNull) {
  Strips strips{0, 1, {0}, {0.0}, {{"a \"name\"", {{std::numeric_limits<float>::infinity()}}}}};
  EXPECT_EQ(checked_text(strips), R"({"exploration":0,"frames":1,"frame":[0],"time":[0],)"
                                  R"("channels":{"a \"name\"":[[null]]}})");
}

}  // namespace
}  // namespace somato::live
