#include "somato/bodies/explore_by.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace somato {
namespace {

// A stick with 10 mm/s, and a potentiometer that says of each moment what a test wants.
class SayingBody : public Body {
 public:
  explicit SayingBody(std::function<double(double)> says) : says_(std::move(says)) {
    description_.degrees_of_freedom = {{"stick", "mm", 0, 5, 10}};
    description_.sensors = {{"potentiometer", "counts", {}, {}, 0.0, true}};
    state_.positions = {0};
  }
  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }
  bool silent = false;
  double stuck_at = 5.0;

 protected:
  Result<void> drive_to(std::span<const double> targets) override {
    target_ = targets[0];
    return {};
  }
  Result<void> pass(double seconds) override {
    state_.time += seconds;
    const double way = std::clamp(target_ - state_.positions[0], -10 * seconds, 10 * seconds);
    state_.positions[0] = std::min(state_.positions[0] + way, stuck_at);
    state_.readings = {silent ? Matrix<float>(0, 1)
                              : Matrix<float>(1, 1, static_cast<float>(says_(state_.time)))};
    return {};
  }

 private:
  std::function<double(double)> says_;
  BodyDescription description_;
  BodyState state_;
  double target_ = 0.0;
};

void expect_no_rest(SayingBody& body) {
  const auto refused = explore_by_pressing(body);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_EQ(refused.error().where, "stick");
  EXPECT_NE(refused.error().what.find("rest"), std::string::npos);
}

TEST(Pressing, ReadsOnceAndOnlyWhenItRests) {
  SayingBody body([](double time) { return time < 6.0 ? 1000.0 * time : 6000.0; });
  const auto exploration = explore_by_pressing(body);
  ASSERT_TRUE(exploration);
  ASSERT_EQ(exploration->channels.size(), 1U);
  EXPECT_EQ(exploration->channels[0].frames, Matrix<float>(1, 1, 6000.0F));
  EXPECT_GT(body.state().time, 6.0);
  EXPECT_LT(body.state().time, 8.0);
}

TEST(Pressing, RecordsEachReading) {
  SayingBody body([](double time) { return time < 6.0 ? 1000.0 * time : 6000.0; });
  float last = 0.0F;
  body.observe([&](Readings readings) -> Result<void> {
    EXPECT_EQ(readings, Readings::kRecorded);
    last = body.state().readings[0](0, 0);
    return {};
  });
  const auto explored = explore_by_pressing(body);
  ASSERT_TRUE(explored);
  EXPECT_EQ(last, explored->channels[0].frames(0, 0));
  body.observe([](Readings) -> Result<void> { return fail(ErrorKind::kInterrupted, "enough"); });
  const auto ended = explore_by_pressing(body);
  EXPECT_EQ(ended.error().kind, ErrorKind::kInterrupted);
}

TEST(Pressing, WaitsForTheDriverToo) {
  SayingBody body([](double) { return 100.0; });
  ASSERT_TRUE(explore_by_pressing(body));
  EXPECT_EQ(body.state().positions, std::vector<double>{5.0});
}

TEST(Pressing, NoiseIsNoMovement) {
  int reading = 0;
  SayingBody body([&](double) { return 5000.0 + 400.0 * std::sin(2.4 * ++reading); });
  EXPECT_TRUE(explore_by_pressing(body));
}

TEST(Pressing, TwoReadingsAreEnoughToSeeWhetherItRests) {
  SayingBody body([](double) { return 100.0; });
  PressParameters parameters;
  parameters.readings = 2;
  EXPECT_TRUE(explore_by_pressing(body, parameters));
}

TEST(Pressing, AStickThatNeverRestsIsAnError) {
  SayingBody creeping([](double time) { return 50.0 * time; });
  expect_no_rest(creeping);
  SayingBody swinging([](double time) { return 5000.0 + 1000.0 * std::sin(3.0 * time); });
  expect_no_rest(swinging);
  SayingBody stuck([](double) { return 100.0; });
  stuck.stuck_at = 2.0;
  expect_no_rest(stuck);
}

TEST(Pressing, ASensorWithoutReadingIsAnError) {
  SayingBody body([](double) { return 1.0; });
  body.silent = true;
  const auto refused = explore_by_pressing(body);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "potentiometer");
}

TEST(Pressing, WhatCannotBePressedIsRefusedBeforeAnythingMoves) {
  SayingBody body([](double) { return 1.0; });
  PressParameters parameters;
  parameters.to = 5.1;
  EXPECT_FALSE(explore_by_pressing(body, parameters));
  parameters = {};
  parameters.readings = 1;
  const auto refused = explore_by_pressing(body, parameters);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(body.state().time, 0.0);
}

}  // namespace
}  // namespace somato
