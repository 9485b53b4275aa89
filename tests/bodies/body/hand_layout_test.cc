#include "bodies/body/hand_layout.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

BodyDescription two_fingers() {
  BodyDescription body;
  body.name = "hand";
  for (const char* name : {"wrist", "finger2_distal", "finger1_proximal", "finger1_distal",
                           "finger2_proximal", "height"}) {
    body.degrees_of_freedom.push_back({name, "deg", 0, 1, 1});
  }
  body.sensors = {
      {"joints", "deg", {}, {}, 0.0, true},
      {"touch",
       "N",
       {"finger1_proximal_1", "finger1_proximals_1", "finger1_distal_1", "finger1_proximal_2",
        "finger2_proximal_1", "finger2_distal_1", "finger2_distal_12"},
       {},
       0.0,
       true}};
  return body;
}

using Indices = std::vector<std::size_t>;

TEST(HandLayout, IsFoundByNames) {
  const auto layout = hand_layout(two_fingers());
  ASSERT_TRUE(layout) << to_string(layout.error());
  EXPECT_EQ(layout->touch, 1U);
  ASSERT_EQ(layout->fingers.size(), 2U);
  const auto& [first, second] = std::pair(layout->fingers[0], layout->fingers[1]);
  EXPECT_EQ(first.name, "finger1");
  EXPECT_EQ(first.proximal.servo, 2U);
  EXPECT_EQ(first.distal.servo, 3U);
  EXPECT_EQ(first.proximal.taxels, (Indices{0, 3}));
  EXPECT_EQ(first.distal.taxels, (Indices{2}));
  EXPECT_EQ(second.name, "finger2");
  EXPECT_EQ(second.proximal.servo, 4U);
  EXPECT_EQ(second.distal.servo, 1U);
  EXPECT_EQ(second.proximal.taxels, (Indices{4}));
  EXPECT_EQ(second.distal.taxels, (Indices{5, 6}));
}

TEST(HandLayout, Finger1IsNotFinger11) {
  BodyDescription body = two_fingers();
  body.degrees_of_freedom.push_back({"finger11_proximal", "deg", 0, 1, 1});
  body.degrees_of_freedom.push_back({"finger11_distal", "deg", 0, 1, 1});
  body.sensors[1].element_names.emplace_back("finger11_proximal_1");
  body.sensors[1].element_names.emplace_back("finger11_distal_1");
  const auto layout = hand_layout(body).value();
  EXPECT_EQ(layout.fingers.at(0).proximal.taxels, (Indices{0, 3}));
  EXPECT_EQ(layout.fingers.at(2).proximal.taxels, (Indices{7}));
}

void expect_refused(const BodyDescription& body, const std::string& word) {
  const auto layout = hand_layout(body);
  ASSERT_FALSE(layout) << word;
  EXPECT_EQ(layout.error().kind, ErrorKind::kUsage);
  const std::string message = to_string(layout.error());
  EXPECT_NE(message.find(word), std::string::npos) << message;
}

TEST(HandLayout, WhatIsNoHandIsRefused) {
  BodyDescription no_touch = two_fingers();
  no_touch.sensors.pop_back();
  expect_refused(no_touch, "unknown sensor 'touch'");
  BodyDescription no_distal = two_fingers();
  no_distal.degrees_of_freedom[1].name = "other";
  expect_refused(no_distal, "'finger2_distal'");
  BodyDescription no_taxels = two_fingers();
  no_taxels.sensors[1].element_names[4] = "palm_2";
  expect_refused(no_taxels, "the segment 'finger2_proximal' has no taxels");
  BodyDescription no_fingers = two_fingers();
  no_fingers.degrees_of_freedom.resize(2);
  expect_refused(no_fingers, "'hand' has no fingers");
}

}  // namespace
}  // namespace somato
