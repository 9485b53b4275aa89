#include "recordings/bags/topic_use.h"

#include <gtest/gtest.h>

#include <string>

#include "recordings/bags/made_bag.h"

namespace somato {
namespace {

BagTopic stamped_topic() {
  return {"/x",
          {"a/msg/X", "cdr", "ros2msg",
           "std_msgs/Header header\nfloat64[] x\n===\nMSG: std_msgs/Header\n"
           "builtin_interfaces/Time stamp\nstring frame_id\n"}};
}

BagImport with_channel(const std::string& field) {
  BagImport description;
  description.channels.push_back({"x", "", "/x", {field}, "", {}, 1.0});
  return description;
}

TEST(TopicUse, FieldsOfTheDescriptionAreCompiled) {
  BagImport description = with_channel("x");
  description.labels.push_back({"frame", "", "/x", "header.frame_id"});
  description.labels.push_back({"first", "", "/x", "x[0]"});
  description.trials.clock = BagClock::kHeader;
  const auto use = use_of_topic(stamped_topic(), description);
  ASSERT_TRUE(use) << to_string(use.error());
  const std::string message = stamped_message(7, {0.5, 2.0});
  EXPECT_EQ(use->channels.size(), 1U);
  EXPECT_EQ(words_at(use->labels[0].reader, message).value(), "");
  EXPECT_EQ(words_at(use->labels[1].reader, message).value(), "0.5");
  EXPECT_EQ(stamp_in(*use->stamp, message).value(), 7'000'000'000);
  EXPECT_TRUE(use->reason.empty());
}

TEST(TopicUse, UnusedTopicsHaveAReason) {
  BagTopic other = stamped_topic();
  other.name = "/y";
  EXPECT_EQ(use_of_topic(other, with_channel("x"))->reason, "no channel or label mentions it");
  EXPECT_EQ(use_of_topic(other, {})->reason.substr(0, 25), "a/msg/X is not a known ty");
  BagImport events = with_channel("x");
  events.trials.events = "/y";
  EXPECT_TRUE(use_of_topic(other, events)->is_event);
  EXPECT_TRUE(use_of_topic(other, events)->reason.empty());
}

TEST(TopicUse, ErrorsNameTheTopic) {
  const auto use = use_of_topic(stamped_topic(), with_channel("y"));
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().where, "topic /x, y");
  BagTopic plain = stamped_topic();
  plain.encoding.definition = "float64[] x\n";
  BagImport header = with_channel("x");
  header.trials.clock = BagClock::kHeader;
  EXPECT_FALSE(use_of_topic(plain, header));
}

}  // namespace
}  // namespace somato
