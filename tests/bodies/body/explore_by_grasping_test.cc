#include "somato/bodies/explore_by.h"

#include <gtest/gtest.h>

#include "bodies/support/fake_hand.h"

namespace somato {
namespace {

using Positions = std::vector<double>;
using Frame = std::vector<float>;

// Height, wrist and one finger, all of which it also reports. At wrist angles above 0 the finger
// meets walls at 10 and -20 deg (2 N a deg), elsewhere nothing. Closing takes 8 + 14 iterations
// there, 20 + 27 elsewhere, and 3 more.
class ExploreByGrasping : public ::testing::Test {
 protected:
  ExploreByGrasping() : hand_("hand") {
    hand_.add_servo({"height", "mm", 100, 200, 50}, 180);
    hand_.add_servo({"wrist", "deg", -90, 90, 60}, 5);
    add_finger(hand_, "finger1");
    hand_.add_sensor({"touch", "N", {"finger1_proximal_1", "finger1_distal_1"}, {}, 0.0, true},
                     [this](const Positions& at) {
                       if (at[1] <= 0 || !object_) return Frame{0, 0};
                       return Frame{pressed(at[2], 10, 2), pressed(at[3], -20, 2)};
                     });
    hand_.add_sensor({"driven", "", {"height", "wrist", "proximal", "distal"}, {}, 0.0, true},
                     [](const Positions& at) { return Frame(at.begin(), at.end()); });
    plan_ = {{126, 148}, {-24, 24}, 3};
  }

  FakeHand hand_;
  bool object_ = true;
  ExplorationPlan plan_;
};

TEST_F(ExploreByGrasping, RecordsOnlyTheGrasps) {
  const auto exploration = explore_by_grasping(hand_, plan_, {});
  ASSERT_TRUE(exploration) << to_string(exploration.error());
  EXPECT_TRUE(validate(Recording{{*exploration}}));
  EXPECT_TRUE(exploration->labels.empty());
  ASSERT_EQ(exploration->channels.size(), 2U);
  const Channel& driven = exploration->channels[1];
  EXPECT_EQ(driven.element_names,
            (std::vector<std::string>{"height", "wrist", "proximal", "distal"}));
  EXPECT_EQ(exploration->channels[0].frames.rows(), driven.frames.rows());
  std::vector<std::vector<float>> expected;
  for (const auto& [height, wrist, touched] :
       {std::tuple{126.F, -24.F, false}, {126.F, 24.F, true}, {148.F, 24.F, true}}) {
    const int proximal = touched ? 8 : 20;
    const int distal = touched ? 14 : 27;
    for (int i = 1; i <= proximal + distal + 3; ++i) {
      expected.push_back(
          {height, wrist, 1.5F * static_cast<float>(std::min(i, proximal)),
           std::min(30.F, -75 + 4 * static_cast<float>(std::clamp(i - proximal, 0, distal)))});
    }
  }
  ASSERT_EQ(driven.frames.rows(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(driven.frames(i, j), expected[i][j], 1e-4) << i << " " << j;
    }
  }
}

TEST_F(ExploreByGrasping, TheClockRunsOnBetweenGrasps) {
  const auto exploration = explore_by_grasping(hand_, plan_, {});
  const std::vector<double>& times = exploration->channels[0].times;
  ASSERT_EQ(times.size(), 50U + 25U + 25U);
  for (const std::size_t first : {50U, 75U}) EXPECT_GT(times[first] - times[first - 1], 0.5);
  EXPECT_NEAR(times[49] - times[0], 4.9, 1e-9);
  EXPECT_LT(times.back(), hand_.state().time - 0.2);
}

TEST_F(ExploreByGrasping, TheHandTravelsOpen) {
  ASSERT_TRUE(explore_by_grasping(hand_, plan_, {}));
  std::size_t travelling = 0;
  for (std::size_t i = 1; i < hand_.path.size(); ++i) {
    const bool travels =
        hand_.path[i][0] != hand_.path[i - 1][0] || hand_.path[i][1] != hand_.path[i - 1][1];
    if (!travels) continue;
    ++travelling;
    EXPECT_NEAR(hand_.path[i - 1][2], 0, 0.1);
    EXPECT_NEAR(hand_.path[i - 1][3], -75, 0.1);
  }
  EXPECT_GT(travelling, 20U);
  EXPECT_NEAR(hand_.path.back()[2], 0, 0.1);
  EXPECT_NEAR(hand_.path.back()[3], -75, 0.1);
  // The fingers open before anything else moves.
  EXPECT_EQ(hand_.commands.front(), (Positions{180, 5, 0, -75}));
}

TEST_F(ExploreByGrasping, AHandThatNeverTouchesIsAnError) {
  object_ = false;
  const auto exploration = explore_by_grasping(hand_, plan_, {});
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().kind, ErrorKind::kData);
  EXPECT_EQ(exploration.error().what, "the hand never touched the object");
}

TEST_F(ExploreByGrasping, OneTouchInOneGraspIsEnough) {
  plan_ = {{126}, {-24, 24}, 2};
  EXPECT_TRUE(explore_by_grasping(hand_, plan_, {}));
  plan_ = {{126}, {24, -24}, 2};
  EXPECT_TRUE(explore_by_grasping(hand_, plan_, {}));
  plan_ = {{126}, {-24}, 1};
  EXPECT_FALSE(explore_by_grasping(hand_, plan_, {}));
}

TEST_F(ExploreByGrasping, AGraspThatNeverClosesIsNamed) {
  GuardedGrasp grasp;
  grasp.most_iterations = 30;
  plan_ = {{126}, {24, -24.5}, 2};
  const auto exploration = explore_by_grasping(hand_, plan_, grasp);
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().kind, ErrorKind::kData);
  EXPECT_EQ(exploration.error().where, "grasp 2 of 2 (height 126 mm, wrist -24.5 deg)");
}

TEST_F(ExploreByGrasping, APoseBeyondTheLimitsIsNamed) {
  plan_ = {{126, 201}, {24}, 2};
  const auto exploration = explore_by_grasping(hand_, plan_, {});
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().where, "grasp 2 of 2 (height 201 mm, wrist 24 deg), height");
}

TEST_F(ExploreByGrasping, WhatTheBodySuffersIsPassedOn) {
  hand_.failing_step = 1;
  EXPECT_EQ(explore_by_grasping(hand_, plan_, {}).error().what, "the simulation diverged");
  hand_.failing_step = 40;
  const auto later = explore_by_grasping(hand_, plan_, {});
  EXPECT_EQ(later.error().what, "the simulation diverged");
  EXPECT_TRUE(later.error().where.starts_with("grasp "));
}

TEST_F(ExploreByGrasping, APlanOrBodyThatDoesNotFitIsRefusedBeforeAnythingMoves) {
  plan_.grasps = 5;
  EXPECT_EQ(explore_by_grasping(hand_, plan_, {}).error().kind, ErrorKind::kUsage);
  EXPECT_TRUE(hand_.commands.empty());
  FakeHand fixed("hand");
  add_finger(fixed, "finger1");
  fixed.add_sensor({"touch", "N", {"finger1_proximal_1", "finger1_distal_1"}, {}, 0.0, true},
                   [](const Positions&) { return Frame{0, 0}; });
  const auto refused = explore_by_grasping(fixed, {}, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("'height'"), std::string::npos);
  EXPECT_TRUE(fixed.commands.empty());
}

TEST_F(ExploreByGrasping, RecordsTheStepsOfTheGraspsOnly) {
  std::size_t recorded = 0;
  std::size_t steps = 0;
  hand_.observe([&](Readings readings) -> Result<void> {
    ++steps;
    if (readings == Readings::kRecorded) ++recorded;
    return {};
  });
  const auto exploration = explore_by_grasping(hand_, plan_, {});
  ASSERT_TRUE(exploration);
  EXPECT_EQ(recorded, exploration->channels.front().frames.rows());
  EXPECT_GT(steps, recorded);
}

}  // namespace
}  // namespace somato
