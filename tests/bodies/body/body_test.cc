#include "somato/bodies/body.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

// Two servos that obey at once, and count what reaches them.
class PlainBody : public Body {
 public:
  PlainBody() {
    description_.degrees_of_freedom = {{"lift", "mm", 0, 100, 10}, {"wrist", "deg", -90, 90, 60}};
    description_.sensors = {{"touch", "N", {}, {}, 0.0, true}};
    state_.positions = {0, 0};
  }
  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }
  int steps = 0;

 protected:
  Result<void> drive_to(std::span<const double> targets) override {
    state_.positions.assign(targets.begin(), targets.end());
    return {};
  }
  Result<void> pass(double seconds) override {
    state_.time += seconds;
    ++steps;
    return {};
  }

 private:
  BodyDescription description_;
  BodyState state_;
};

TEST(Body, CommandsWithinTheLimitsGoThroughWithTheLimitsThemselves) {
  PlainBody body;
  for (const std::vector<double>& targets :
       std::vector<std::vector<double>>{{0, -90}, {100, 90}, {50, 1}}) {
    ASSERT_TRUE(body.command(targets));
    EXPECT_EQ(body.state().positions, targets);
  }
}

TEST(Body, ACommandBeyondTheLimitsIsRefusedAndMovesNothing) {
  PlainBody body;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrist : {90.001, -90.001, 1e300, nan}) {
    const auto refused = body.command(std::vector<double>{50, wrist});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kData);
    EXPECT_EQ(refused.error().where, "wrist");
    EXPECT_NE(refused.error().what.find("-90 to 90 deg"), std::string::npos);
    EXPECT_EQ(body.state().positions, (std::vector<double>{0, 0}));
  }
}

TEST(Body, TheCallersMistakesThrow) {
  PlainBody body;
  EXPECT_THROW((void)body.command(std::vector<double>{1}), InvalidArgument);
  for (const double seconds : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)body.step(seconds), InvalidArgument);
  }
  EXPECT_EQ(body.steps, 0);
}

TEST(Body, ServosAndSensorsAreFoundByName) {
  const PlainBody body;
  EXPECT_EQ(find_degree_of_freedom(body.description(), "wrist"), 1U);
  EXPECT_EQ(find_sensor(body.description(), "touch"), 0U);
  const auto unknown = find_degree_of_freedom(body.description(), "wirst");
  ASSERT_FALSE(unknown);
  EXPECT_NE((unknown.error().what + unknown.error().advice).find("wrist"), std::string::npos);
}

TEST(Body, TakesNoMoreThanItsTime) {
  PlainBody body;
  body.keep_to({.longest = 2.0});
  ASSERT_TRUE(body.step(1.5));
  const auto refused = body.step(0.6);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_EQ(refused.error().what, "the exploration takes more than 2 s of the body's time");
  EXPECT_EQ(body.steps, 1);
  EXPECT_TRUE(body.step(0.5));
}

TEST(Body, IsStopped) {
  PlainBody body;
  bool should_continue = true;
  body.keep_to({.should_continue = [&] { return should_continue; }});
  ASSERT_TRUE(body.step(1.0));
  should_continue = false;
  const auto stopped = body.step(1.0);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(body.steps, 1);
}

TEST(Body, IsObservedAfterEachStep) {
  PlainBody body;
  std::vector<std::pair<double, Readings>> seen;
  body.observe([&](Readings readings) -> Result<void> {
    seen.emplace_back(body.state().time, readings);
    if (seen.size() < 2) return {};
    return fail(ErrorKind::kInterrupted, "enough");
  });
  EXPECT_TRUE(body.step(1.0));
  EXPECT_EQ(body.step(0.5, Readings::kRecorded).error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(seen, (std::vector<std::pair<double, Readings>>{{1.0, Readings::kLeftOut},
                                                            {1.5, Readings::kRecorded}}));
}

}  // namespace
}  // namespace somato
