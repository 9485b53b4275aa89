#include "bodies/body/guarded_grasp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/files/toml_file.h"
#include "bodies/body/frame_log.h"
#include "bodies/body/motion.h"
#include "bodies/support/fake_hand.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using Positions = std::vector<double>;
using Frame = std::vector<float>;

// One finger with two taxels on its proximal segment (servo 0) and one on its distal one (servo 1).
class OneFinger : public ::testing::Test {
 protected:
  void make(FakeHand::Feel feel, double fastest = 300.0) {
    hand_.emplace("hand");
    add_finger(*hand_, "finger1", fastest);
    hand_->add_sensor({"touch",
                       "N",
                       {"finger1_proximal_1", "finger1_proximal_2", "finger1_distal_1"},
                       {},
                       0.0,
                       true},
                      std::move(feel));
  }

  Result<GraspResult> close() {
    const HandLayout layout = hand_layout(hand_->description()).value();
    targets_ = {grasp_.proximal_open, grasp_.distal_open};
    EXPECT_TRUE(move_to(*hand_, targets_, {0.5, 200}));
    started_ = hand_->state().time;
    FrameLog log(hand_->description());
    auto result = guarded_grasp(*hand_, layout, grasp_, targets_, log);
    channels_ = std::move(log).channels();
    return result;
  }

  // The angles of a servo after each iteration.
  std::vector<double> angles(std::size_t servo) const {
    std::vector<double> angles;
    for (std::size_t i = hand_->path.size() - channels_[0].frames.rows(); i < hand_->path.size();
         ++i) {
      angles.push_back(hand_->path[i][servo]);
    }
    return angles;
  }

  std::optional<FakeHand> hand_;
  GuardedGrasp grasp_;
  Positions targets_;
  double started_ = 0.0;
  std::vector<Channel> channels_;
};

// Walls at 10 and -20 deg. The two proximal taxels together change by 0.4 N a deg: 12.0 deg are
// 0.8 N, 13.5 deg, after 9 iterations, 1.4 N. The distal one by 1 N a deg: -19 deg are exactly the
// threshold, which does not stop it; -15 deg, after 15 iterations, do.
Frame walls(const Positions& at) {
  return {pressed(at[0], 10, 0.2), pressed(at[0], 10, 0.2), pressed(at[1], -20, 1)};
}

TEST_F(OneFinger, EachSegmentStopsOneIterationAfterItFeelsTooMuch) {
  make(walls);
  const auto result = close();
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->iterations, 9U + 15U + 3U);
  EXPECT_EQ(result->touching, 2U);
  EXPECT_EQ(targets_, (Positions{13.5, -15}));
  std::vector<double> proximal;
  std::vector<double> distal;
  for (int i = 1; i <= 27; ++i) {
    proximal.push_back(1.5 * std::min(i, 9));
    distal.push_back(-75 + 4 * std::clamp(i - 9, 0, 15));
  }
  EXPECT_EQ(angles(0), proximal);
  EXPECT_EQ(angles(1), distal);
}

TEST_F(OneFinger, EveryIterationIsLogged) {
  make(walls);
  ASSERT_TRUE(close());
  const Channel& touch = channels_.at(0);
  ASSERT_EQ(touch.frames.rows(), 27U);
  for (std::size_t i = 0; i < 27; ++i) {
    const Frame expected = walls({angles(0)[i], angles(1)[i]});
    EXPECT_EQ(Frame(touch.frames.row(i).begin(), touch.frames.row(i).end()), expected);
    EXPECT_NEAR(touch.times[i], started_ + 0.1 * static_cast<double>(i + 1), 1e-9);
  }
}

TEST_F(OneFinger, WithoutAnythingToFeelItClosesToItsLimits) {
  make([](const Positions&) { return Frame{0, 0, 0}; });
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->iterations, 20U + 27U + 3U);  // 30 deg by 1.5, 105 deg by 4
  EXPECT_EQ(result->touching, 0U);
  EXPECT_EQ(targets_, (Positions{30, 30}));
}

TEST_F(OneFinger, StepsTimeAndThresholdAreParameters) {
  make(walls);
  grasp_.iteration = 0.25;
  grasp_.proximal_step = 3;
  grasp_.distal_step = 5;
  grasp_.threshold = 2.1;  // proximal 15.25 deg: 6 steps; distal -17.9: 12 steps
  grasp_.still_iterations = 0;
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->iterations, 6U + 12U);
  EXPECT_EQ(targets_, (Positions{18, -15}));
  EXPECT_NEAR(hand_->state().time, started_ + 18 * 0.25, 1e-9);
}

TEST_F(OneFinger, AFallCountsLikeARiseAndDoesNotCancelIt) {
  // One taxel gains what the other one loses.
  make([](const Positions& at) {
    return Frame{3 + pressed(at[0], 10, 0.2), 3 - pressed(at[0], 10, 0.2), 0};
  });
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->touching, 1U);
  EXPECT_EQ(targets_[0], 13.5);
}

TEST_F(OneFinger, WhatIsFeltInTheOpenHandDoesNotCount) {
  make([](const Positions& at) {
    Frame frame = walls(at);
    for (float& value : frame) value += 100;
    return frame;
  });
  ASSERT_TRUE(close());
  EXPECT_EQ(targets_, (Positions{13.5, -15}));
}

TEST_F(OneFinger, TheDistalSegmentCountsFromWhereTheProximalOneStopped) {
  // The distal taxel feels the proximal segment move, and itself only beyond its wall.
  make([](const Positions& at) {
    Frame frame = walls(at);
    frame[2] += static_cast<float>(at[0]);
    return frame;
  });
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->iterations, 27U);
  EXPECT_EQ(targets_, (Positions{13.5, -15}));
}

TEST_F(OneFinger, ASegmentFeelsOnlyItsOwnTaxels) {
  // The distal taxel presses throughout the proximal segment's way, and the other way round.
  make([](const Positions& at) {
    const auto distal = static_cast<float>(at[0] < 13.4 ? at[0] : 0.0);
    return Frame{pressed(at[0], 10, 0.4) + static_cast<float>(at[1]), 0, distal};
  });
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(targets_, (Positions{13.5, 30}));
}

TEST_F(OneFinger, AServoThatLagsBehindStopsWhereItIs) {
  make(walls, 10);  // 1 deg an iteration, its target 1.5: it touches at 13, sent to 19.5
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_NEAR(targets_[0], 13, 1e-9);
  EXPECT_NEAR(angles(0).back(), 13, 1e-9);
  EXPECT_NEAR(targets_[1], -18, 1e-9);  // 57 steps of 1 deg: at -19 the threshold is not exceeded
  EXPECT_EQ(result->iterations, 13U + 57U + 3U);
}

TEST_F(OneFinger, ALimitIsReachedWhenTheServoStandsThere) {
  make([](const Positions&) { return Frame{0, 0, 0}; }, 10);
  const auto result = close();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->iterations, 30U + 105U + 3U);
}

TEST_F(OneFinger, TooManyIterationsAreAnErrorThatNamesTheFinger) {
  make(walls);
  grasp_.most_iterations = 27;
  EXPECT_TRUE(close());
  grasp_.most_iterations = 26;
  auto result = close();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kData);
  EXPECT_EQ(result.error().what, "the hand never closed: after 26 iterations it was not at rest");
  grasp_.most_iterations = 23;
  result = close();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().what, "the hand never closed: after 23 iterations finger1 still moved");
}

TEST_F(OneFinger, AHandThatCannotReachItsLimitNeverCloses) {
  make([](const Positions&) { return Frame{0, 0, 0}; });
  hand_->stops = {29, 30};
  const auto result = close();
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().what.find("never closed"), std::string::npos);
  EXPECT_EQ(channels_[0].frames.rows(), 200U);
}

TEST_F(OneFinger, WhatTheBodySuffersIsPassedOn) {
  make(walls);
  hand_->failing_step = 12;
  const auto result = close();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().what, "the simulation diverged");
}

TEST_F(OneFinger, ReadingsThatAreNoneAreErrors) {
  make([](const Positions&) { return Frame{0, 0}; });
  const auto few = close();
  ASSERT_FALSE(few);
  EXPECT_NE(few.error().what.find("gave 2 elements, not 3"), std::string::npos);

  make(walls);
  FrameLog log(hand_->description());
  std::vector<double> targets{0, -75};
  const HandLayout layout = hand_layout(hand_->description()).value();
  EXPECT_EQ(guarded_grasp(*hand_, layout, {}, targets, log).error().where, "touch");
  targets.pop_back();
  EXPECT_THROW((void)guarded_grasp(*hand_, layout, {}, targets, log), InvalidArgument);
}

TEST(GuardedGrasp, FingersCloseIndependently) {
  FakeHand hand("hand");
  hand.add_servo({"wrist", "deg", -90, 90, 60}, 0);
  add_finger(hand, "finger1");
  add_finger(hand, "finger2");
  // Finger 1 meets walls at 5 and -60 deg, finger 2 nothing; 2 N a deg.
  hand.add_sensor(
      {"touch",
       "N",
       {"finger1_proximal_1", "finger1_distal_1", "finger2_proximal_1", "finger2_distal_1"},
       {},
       0.0,
       true},
      [](const Positions& at) {
        return Frame{pressed(at[1], 5, 2), pressed(at[2], -60, 2), 0, 0};
      });
  std::vector<double> targets{17, 0, -75, 0, -75};
  ASSERT_TRUE(move_to(hand, targets));
  FrameLog log(hand.description());
  const auto result =
      guarded_grasp(hand, hand_layout(hand.description()).value(), {}, targets, log);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->iterations, 50U);  // as long as the slower one takes
  EXPECT_EQ(result->touching, 2U);
  EXPECT_EQ(targets, (Positions{17, 6, -59, 30, 30}));
}

// A finger with walls at 10 and -20 deg, 2 N per deg above the 5 N that its taxels always report,
// sampled at the given rate. The grasp begins at 0.55 s of the body's clock.
struct Sampled {
  explicit Sampled(double rate) : hand("hand"), log({}) {
    add_finger(hand, "finger1");
    hand.add_sensor({"touch", "N", {"finger1_proximal_1", "finger1_distal_1"}, {}, rate, false},
                    [](const Positions& at) {
                      return Frame{5 + pressed(at[0], 10, 2), 5 + pressed(at[1], -20, 2)};
                    });
    EXPECT_TRUE(move_to(hand, targets));
    EXPECT_NEAR(hand.state().time, 0.55, 1e-9);
    log = FrameLog(hand.description());
    const HandLayout layout = hand_layout(hand.description()).value();
    result = guarded_grasp(hand, layout, {}, targets, log);
  }
  FakeHand hand;
  FrameLog log;
  std::vector<double> targets{0, -75};
  Result<GraspResult> result;
};

TEST(GuardedGrasp, ASlowSensorIsRememberedBetweenItsFrames) {
  Sampled slow(5);  // It has readings only in the odd iterations.
  ASSERT_TRUE(slow.result);
  EXPECT_EQ(slow.targets, (Positions{13.5, -19}));
  EXPECT_EQ(slow.result->iterations, 9U + 14U + 3U);
  EXPECT_EQ(std::move(slow.log).channels()[0].frames.rows(), 13U);
}

TEST(GuardedGrasp, AFastSensorsLastFrameCounts) {
  Sampled fast(40);
  ASSERT_TRUE(fast.result);
  EXPECT_EQ(fast.targets, (Positions{12, -19}));
  EXPECT_EQ(fast.result->iterations, 8U + 14U + 3U);
  EXPECT_EQ(std::move(fast.log).channels()[0].frames.rows(), 4U * 25U);
}

TEST(GuardedGrasp, ASensorWithoutAFrameBeforeTheGraspIsAnError) {
  const Sampled late(1);
  ASSERT_FALSE(late.result);
  EXPECT_EQ(late.result.error().where, "touch");
}

TEST(GuardedGrasp, ComesFromADescription) {
  const auto table = parse_toml("threshold = 0.5\nsettle = 1.5\ndistal_open = -60\n", "grasp");
  const auto grasp = read_parameters<GuardedGrasp>(*table);
  ASSERT_TRUE(grasp);
  EXPECT_EQ(grasp->threshold, 0.5);
  EXPECT_EQ(grasp->motion.settle, 1.5);
  EXPECT_EQ(grasp->distal_open, -60.0);
  for (const char* wrong : {"iteration = 0", "threshold = -1", "most_iterations = 0",
                            "proximal_step = 0", "distal_step = -4", "settle = 0"}) {
    EXPECT_FALSE(read_parameters<GuardedGrasp>(*parse_toml(wrong, "grasp"))) << wrong;
  }
}

}  // namespace
}  // namespace somato
