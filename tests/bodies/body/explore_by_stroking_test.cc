#include "somato/bodies/explore_by.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace somato {
namespace {

// A lever with 10 deg/s and a sound of 100 frames a second that counts its own frames.
class CountingBody : public Body {
 public:
  CountingBody() {
    description_.degrees_of_freedom = {{"lever", "deg", 0, 90, 10}};
    description_.sensors = {{"temperature", "K", {}, {}, 0.0, true},
                            {"sound", "counts", {}, {}, 100.0, true}};
    state_.positions = {0};
    state_.readings.resize(2);
  }
  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }

  BodyDescription description_;
  BodyState state_;
  double lost = 0.0;         // Share of the frames that never come.
  double stuck_at = 90.0;    // deg
  double fails_after = 1e9;  // s
  double target_ = 0.0;
  double frame_ = 0.0;

 protected:
  Result<void> drive_to(std::span<const double> targets) override {
    target_ = targets[0];
    return {};
  }
  Result<void> pass(double seconds) override {
    state_.time += seconds;
    if (state_.time > fails_after) return fail(ErrorKind::kSystem, "the line is dead");
    const double way = std::clamp(target_ - state_.positions[0], -10 * seconds, 10 * seconds);
    state_.positions[0] = std::min(state_.positions[0] + way, stuck_at);
    std::vector<float> frames;
    for (; frame_ < std::round(state_.time * 100.0); ++frame_) {
      if (std::fmod(frame_ * lost, 1.0) < 1.0 - lost) frames.push_back(static_cast<float>(frame_));
    }
    const std::size_t count = frames.size();
    state_.readings[1] = Matrix<float>(count, 1, std::move(frames));
    return {};
  }
};

void expect_failure(CountingBody& body, const StrokeParameters& parameters, ErrorKind kind,
                    const std::string& word) {
  const auto refused = explore_by_stroking(body, parameters);
  ASSERT_FALSE(refused) << word;
  EXPECT_EQ(refused.error().kind, kind);
  EXPECT_NE(to_string(refused.error()).find(word), std::string::npos) << to_string(refused.error());
}

TEST(Stroking, RecordsOnlyTheFramesOfTheStroke) {
  CountingBody body;
  StrokeParameters parameters;
  parameters.from = 5.0;  // half a second away
  parameters.to = 35.0;   // three seconds
  parameters.settle = 0.25;
  for (const double step : {0.1, 0.07, 5.0}) {
    CountingBody fresh;
    parameters.step = step;
    const auto exploration = explore_by_stroking(fresh, parameters);
    ASSERT_TRUE(exploration) << to_string(exploration.error());
    ASSERT_EQ(exploration->channels.size(), 1U);
    const Channel& sound = exploration->channels[0];
    EXPECT_EQ(sound.rate, 100.0);
    ASSERT_EQ(sound.frames.rows(), 300U);
    for (std::size_t i = 0; i < 300; ++i) ASSERT_EQ(sound.frames(i, 0), static_cast<float>(75 + i));
  }
}

TEST(Stroking, RecordsTheStepsOfTheStrokeOnly) {
  CountingBody body;
  StrokeParameters parameters;
  parameters.from = 5.0;
  parameters.to = 35.0;
  parameters.step = 0.5;
  std::size_t frames = 0;
  std::size_t steps = 0;
  body.observe([&](Readings readings) -> Result<void> {
    if (readings == Readings::kLeftOut) return {};
    ++steps;
    frames += body.state().readings[1].rows();
    return {};
  });
  const auto explored = explore_by_stroking(body, parameters);
  ASSERT_TRUE(explored);
  EXPECT_EQ(steps, 6U);
  EXPECT_EQ(frames, explored->channels[0].frames.rows());
  body.observe([](Readings) -> Result<void> { return fail(ErrorKind::kInterrupted, "enough"); });
  const auto ended = explore_by_stroking(body, parameters);
  EXPECT_EQ(ended.error().kind, ErrorKind::kInterrupted);
}

TEST(Stroking, AStrokeMayGoBackwards) {
  CountingBody body;
  StrokeParameters parameters;
  parameters.from = 30.0;
  parameters.to = 10.0;
  const auto exploration = explore_by_stroking(body, parameters);
  ASSERT_TRUE(exploration);
  EXPECT_EQ(exploration->channels[0].frames.rows(), 200U);
  EXPECT_NEAR(body.state().positions[0], 10.0, 1e-9);
}

TEST(Stroking, FramesThatDoNotComeAreAnError) {
  CountingBody body;
  body.lost = 0.01;
  expect_failure(body, {}, ErrorKind::kData, "of the stroke's 360 frames");
}

TEST(Stroking, ALeverThatDoesNotArriveIsAnError) {
  CountingBody body;
  body.stuck_at = 20.0;
  expect_failure(body, {}, ErrorKind::kData, "20 deg instead of 36");
}

TEST(Stroking, AFailureOfTheBodyIsPassedOn) {
  for (const double when : {0.1, 2.0}) {
    CountingBody body;
    body.fails_after = when;
    expect_failure(body, {}, ErrorKind::kSystem, "the line is dead");
  }
}

TEST(Stroking, WhatCannotBeStrokedIsRefusedBeforeAnythingMoves) {
  StrokeParameters parameters;
  parameters.to = 0.04;
  CountingBody body;
  expect_failure(body, parameters, ErrorKind::kUsage, "shorter than a frame");
  parameters = {};
  parameters.step = 0.0;
  expect_failure(body, parameters, ErrorKind::kUsage, "step");
  body.description_.sensors[1].rate = 0.0;
  expect_failure(body, {}, ErrorKind::kData, "no rate");
  body.description_.sensors[1].name = "noise";
  expect_failure(body, {}, ErrorKind::kUsage, "sound");
  EXPECT_EQ(body.state().time, 0.0);
}

TEST(Stroking, AStartOrEndBeyondTheLimitsIsRefusedBeforeAnythingMoves) {
  CountingBody body;
  StrokeParameters parameters;
  parameters.from = -5.0;
  expect_failure(body, parameters, ErrorKind::kData, "outside the limits");
  parameters.from = 50.0;
  parameters.to = 90.1;
  expect_failure(body, parameters, ErrorKind::kData, "outside the limits");
  EXPECT_EQ(body.state().time, 0.0);
}

}  // namespace
}  // namespace somato
