#include "bodies/body/motion.h"

#include <gtest/gtest.h>

#include "bodies/support/fake_hand.h"

namespace somato {
namespace {

// A lift of 10 mm/s and a wrist of 60 deg/s.
class MoveTo : public ::testing::Test {
 protected:
  MoveTo() : body_("arm") {
    body_.add_servo({"height", "mm", 0, 100, 10}, 0);
    body_.add_servo({"wrist", "deg", -90, 90, 60}, 0);
  }
  FakeHand body_;
};

TEST_F(MoveTo, WaitsForTheSlowestAndThenSettles) {
  ASSERT_TRUE(move_to(body_, std::vector<double>{4, 12}, {0.7, 20}));
  // 4 mm at 10 mm/s, within 0.1 mm: 8 steps of 0.05 s.
  EXPECT_EQ(body_.steps, (std::vector<double>{.05, .05, .05, .05, .05, .05, .05, .05, .7}));
  EXPECT_EQ(body_.commands, (std::vector<std::vector<double>>{{4, 12}}));
  EXPECT_NEAR(body_.state().positions[0], 4, 1e-9);
}

TEST_F(MoveTo, OnlySettlesWhereItIs) {
  ASSERT_TRUE(move_to(body_, std::vector<double>{0.1, -0.1}, {0.7, 20}));
  EXPECT_EQ(body_.steps, (std::vector<double>{.7}));
  ASSERT_TRUE(move_to(body_, std::vector<double>{0.31, -0.1}, {0.7, 20}));
  EXPECT_EQ(body_.steps.size(), 3U);
}

TEST_F(MoveTo, AServoThatIsHeldIsNamed) {
  body_.stops = {3, 90};
  const auto held = move_to(body_, std::vector<double>{4, 12}, {0.7, 2});
  ASSERT_FALSE(held);
  EXPECT_EQ(held.error().kind, ErrorKind::kData);
  EXPECT_EQ(held.error().where, "height");
  EXPECT_EQ(held.error().what, "'height' did not reach 4 mm: it was at 3 after 2 s");
  EXPECT_EQ(body_.steps, std::vector<double>(40, 0.05));
}

TEST_F(MoveTo, WhatTheBodyRefusesOrSuffersIsPassedOn) {
  EXPECT_EQ(move_to(body_, std::vector<double>{101, 0}).error().where, "height");
  EXPECT_TRUE(body_.steps.empty());
  body_.failing_step = 2;
  EXPECT_EQ(move_to(body_, std::vector<double>{4, 12}).error().what, "the simulation diverged");
  body_.failing_step = 3;
  EXPECT_EQ(move_to(body_, body_.state().positions).error().what, "the simulation diverged");
}

TEST(PresentTargets, LieWithinTheLimits) {
  FakeHand body("arm");
  body.add_servo({"a", "deg", 0, 30, 10}, -0.04);
  body.add_servo({"b", "deg", 0, 30, 10}, 30.04);
  body.add_servo({"c", "deg", 0, 30, 10}, 7);
  EXPECT_EQ(present_targets(body), (std::vector<double>{0, 30, 7}));
}

}  // namespace
}  // namespace somato
