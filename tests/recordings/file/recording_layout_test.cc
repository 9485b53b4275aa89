#include "recordings/file/recording_layout.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "recordings/ros/topic_type.h"

namespace somato {
namespace {

ChannelDescription described(const std::string& name, const std::string& unit) {
  ChannelDescription description;
  description.name = name;
  description.unit = unit;
  return description;
}

std::vector<double> positions_in(const std::string& message) {
  const McapSchema schema = joint_state_schema();
  const TopicType topic = topic_type({schema.name, "cdr", schema.encoding, schema.data});
  std::vector<double> values;
  EXPECT_TRUE(topic.channels.at(0).reader.read(message, values));
  return values;
}

// ROS has joints in radians (REP 103).
TEST(RecordingLayout, JointsInDegreesAreWrittenInRadians) {
  const std::vector<float> degrees{180.0F, -90.0F, 0.0F};
  const std::string message = frame_message(described("joints", "deg"), 0, degrees);
  const std::vector<double> values = positions_in(message);
  ASSERT_EQ(values.size(), 3U);
  EXPECT_NEAR(values[0], std::numbers::pi, 1e-12);
  EXPECT_NEAR(values[1], -std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(frame_values(described("joints", "deg"), true, values), degrees);
}

TEST(RecordingLayout, WhatIsNotInDegreesIsWrittenAsItIs) {
  const std::vector<float> values{180.0F};
  const std::string message = frame_message(described("joints", "rad"), 0, values);
  EXPECT_EQ(positions_in(message), std::vector<double>{180.0});
  EXPECT_EQ(frame_values(described("touch", "deg"), false, std::vector<double>{180.0}), values);
}

// The JSON library, which does not write them, is the oracle.
TEST(RecordingLayout, MessagesAboutExplorationsAreTheJsonOfTheirFields) {
  using Event = ExplorationMessage::Event;
  const ExplorationMessage empty;
  const ExplorationMessage plain{
      Event::kContinue,    3,         {{"object", "ball"}, {"size", ""}}, "the hand, with {}: 2%",
      {"joints", "touch"}, 1500000000};
  const ExplorationMessage odd{
      Event::kBegin,     18446744073709551615U, {{"\"quoted\"", "a\\b\n\t\x01\x7f"}},
      "Gr\u00f6\u00dfe", {"\u89e6\u899a"},      0};
  for (ExplorationMessage message : {empty, plain, odd}) {
    for (const auto& [event, name] : {std::pair{Event::kBegin, "begin"},
                                      {Event::kContinue, "continue"},
                                      {Event::kEnd, "end"}}) {
      message.event = event;
      nlohmann::ordered_json json{{"event", name}, {"index", message.index}};
      if (event != Event::kEnd) {
        json["labels"] = nlohmann::ordered_json::array();
        for (const Label& label : message.labels) {
          json["labels"].push_back({{"name", label.name}, {"value", label.value}});
        }
        json["source"] = message.source;
        json["channels"] = message.channels;
        json["zero"] = std::to_string(message.zero);
      }
      EXPECT_EQ(exploration_json(message), json.dump());
    }
  }
}

TEST(RecordingLayout, TheTopicOfExplorationsStaysFree) {
  EXPECT_EQ(topic_of("touch"), "/touch");
  EXPECT_EQ(topic_of("exploration"), "/exploration_");
  EXPECT_EQ(topic_of("exploration_"), "/exploration__");
  EXPECT_EQ(topic_of("explorations"), "/explorations");
  EXPECT_EQ(topic_of("exploration_1_"), "/exploration_1_");
  EXPECT_NE(topic_of("exploration"), exploration_channel().topic);
}

TEST(RecordingLayout, NamesAreReadFromTopicsAsTheyWere) {
  for (const std::string name : {"touch", "touch_", "exploration", "exploration_", "exploration__",
                                 "explorations", "exploration_1", "exploration_1_", "_"}) {
    EXPECT_EQ(parse_description(channel_for(described(name, ""))).value().name, name);
  }
}

}  // namespace
}  // namespace somato
