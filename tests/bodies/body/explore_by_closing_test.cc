#include "somato/bodies/explore_by.h"

#include <gtest/gtest.h>

#include <optional>

#include "base/files/toml_file.h"
#include "bodies/support/fake_hand.h"

namespace somato {
namespace {

using Positions = std::vector<double>;
using Frame = std::vector<float>;

// Two fingers of 90 deg, 200 and 100 deg/s, a wrist and a lift. At a share of 0.5 they go 10 and
// 5 deg an iteration. The joints are the servos', which an object may stop.
class ExploreByClosing : public ::testing::Test {
 protected:
  void make(double first_stop, double second_stop) {
    hand_.emplace("hand");
    hand_->add_servo({"wrist", "deg", -90, 90, 60}, 12);
    hand_->add_servo({"index_proximal", "deg", 0, 90, 200}, 30);
    hand_->add_servo({"thumb_distal", "deg", -10, 90, 100}, 0);
    hand_->add_servo({"height", "mm", 0, 90, 100}, 7);
    hand_->add_sensor({"joints", "deg", {"index_proximal", "thumb_distal"}, {}, 0.0, true},
                      [=, this](const Positions& at) {
                        return Frame{static_cast<float>(std::min(at[1], first_stop) + offset_),
                                     static_cast<float>(std::min(at[2], second_stop))};
                      });
    closing_.share = 0.5;
  }

  // The joints of each frame.
  std::vector<Frame> explore() {
    const auto exploration = explore_by_closing(*hand_, closing_);
    if (!exploration) {
      ADD_FAILURE() << to_string(exploration.error());
      return {};
    }
    EXPECT_TRUE(validate(Recording{{*exploration}}));
    std::vector<Frame> frames;
    const Channel& joints = exploration->channels.at(0);
    for (std::size_t i = 0; i < joints.frames.rows(); ++i) {
      frames.emplace_back(joints.frames.row(i).begin(), joints.frames.row(i).end());
      EXPECT_NEAR(joints.times[i] - joints.times[0], 0.1 * static_cast<double>(i), 1e-9);
    }
    return frames;
  }

  std::optional<FakeHand> hand_;
  double offset_ = 0.0;
  Closing closing_;
};

TEST_F(ExploreByClosing, FingersCloseAtTheirOwnPaceUntilTheyRest) {
  make(45, 15);
  // Frame k: 10 k up to 45, -10 + 5 k up to 15: nothing moves after frame 5; but the hand continues
  // to press until the slower servo has been driven by its 100 deg, which takes 20 frames.
  std::vector<Frame> expected;
  for (int k = 1; k <= 20; ++k) {
    expected.push_back({std::min(45.F, 10.F * static_cast<float>(k)),
                        std::min(15.F, -10 + 5.F * static_cast<float>(k))});
  }
  EXPECT_EQ(explore(), expected);
}

TEST_F(ExploreByClosing, TheHandOpensFirstAndWristAndLiftStay) {
  make(45, 15);
  ASSERT_EQ(explore().size(), 20U);
  EXPECT_EQ(hand_->commands.front(), (Positions{12, 0, -10, 7}));
  EXPECT_EQ(hand_->commands.back(), (Positions{12, 90, 90, 7}));
  for (const Positions& at : hand_->path) {
    EXPECT_EQ(at[0], 12);
    EXPECT_EQ(at[3], 7);
  }
}

TEST_F(ExploreByClosing, WithoutAnObjectItClosesToItsLimits) {
  make(1000, 1000);
  const std::vector<Frame> frames = explore();
  ASSERT_EQ(frames.size(), 20U + 5U);  // 100 deg by 5, and still
  EXPECT_EQ(frames.back(), (Frame{90, 90}));
}

TEST_F(ExploreByClosing, SlowMovesAreNoStillness) {
  make(1000, 1000);
  closing_.share = 0.005;  // 0.1 and 0.05 deg an iteration, 0.05 beside `still` at once
  closing_.still = 0.12;
  closing_.longest = 1000;
  EXPECT_NEAR(explore().back()[1], 90, 1e-3);
}

TEST_F(ExploreByClosing, SmallMovesAreStillness) {
  make(45, 15);
  int sign = 1;
  hand_->add_sensor({"noise", "", {"n"}, {}, 0.0, true}, [&](const Positions&) {
    offset_ = 0.02 * (sign = -sign);
    return Frame{0};
  });
  EXPECT_EQ(explore().size(), 20U);
  closing_.still = 0.01;
  EXPECT_FALSE(explore_by_closing(*hand_, closing_));
}

TEST_F(ExploreByClosing, AHandThatNeverRestsIsAnError) {
  make(1000, 1000);
  closing_.longest = 2.5;
  EXPECT_EQ(explore().size(), 25U);
  closing_.longest = 2.4;
  const auto refused = explore_by_closing(*hand_, closing_);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(refused.error().what.find("never closed"), std::string::npos);
}

TEST_F(ExploreByClosing, AHandThatNeverMovesHasNotClosed) {
  make(-100, -100);
  const auto refused = explore_by_closing(*hand_, closing_);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("never closed"), std::string::npos);
}

TEST_F(ExploreByClosing, WhatTheBodySuffersIsPassedOn) {
  make(45, 15);
  hand_->failing_step = 1;
  EXPECT_EQ(explore_by_closing(*hand_, closing_).error().what, "the simulation diverged");
  hand_->failing_step = hand_->steps.size() + 12;
  EXPECT_EQ(explore_by_closing(*hand_, closing_).error().what, "the simulation diverged");
}

TEST(ExploreByClosingOf, WhatIsNoHandIsRefused) {
  FakeHand wrist("arm");
  wrist.add_servo({"wrist", "deg", -90, 90, 60}, 0);
  const auto blind = explore_by_closing(wrist, {});
  ASSERT_FALSE(blind);
  EXPECT_NE(blind.error().what.find("'joints'"), std::string::npos);
  wrist.add_sensor({"joints", "deg", {"wrist"}, {}, 0.0, true},
                   [](const Positions&) { return Frame{0}; });
  const auto fingerless = explore_by_closing(wrist, {});
  ASSERT_FALSE(fingerless);
  EXPECT_EQ(fingerless.error().what, "the body 'arm' has no fingers");
  EXPECT_TRUE(wrist.commands.empty());
}

TEST(Closing, ComesFromADescription) {
  const auto closing = read_parameters<Closing>(*parse_toml("share = 1\nlongest = 3\n", "closing"));
  ASSERT_TRUE(closing);
  EXPECT_EQ(closing->share, 1.0);
  EXPECT_EQ(closing->longest, 3.0);
  for (const char* wrong : {"share = 0", "share = 1.1", "still = -1", "still_iterations = 0",
                            "iteration = 0", "longest = 0"}) {
    EXPECT_FALSE(read_parameters<Closing>(*parse_toml(wrong, "closing"))) << wrong;
  }
}

TEST_F(ExploreByClosing, RecordsTheStepsOfTheClosingOnly) {
  make(90, 90);
  std::size_t recorded = 0;
  std::size_t steps = 0;
  hand_->observe([&](Readings readings) -> Result<void> {
    ++steps;
    if (readings == Readings::kRecorded) ++recorded;
    return {};
  });
  const std::size_t frames = explore().size();
  EXPECT_EQ(recorded, frames);
  EXPECT_GT(steps, recorded);
}

}  // namespace
}  // namespace somato
