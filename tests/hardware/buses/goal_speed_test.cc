#include "hardware/buses/goal_speed.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato::devices {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(GoalSpeed, IsThatOfTheGoal) {
  GoalSpeed speed;
  EXPECT_DOUBLE_EQ(speed.next(110.0, 100.0, 100.0, 0.02), 500.0);
  EXPECT_DOUBLE_EQ(speed.next(115.0, 110.0, kUnknown, 0.02), 250.0);
  EXPECT_DOUBLE_EQ(speed.next(105.0, 115.0, kUnknown, 0.04), 250.0);
}

TEST(GoalSpeed, DoesNotFallWhileTheServoLagsBehind) {
  GoalSpeed speed;
  speed.next(110.0, 100.0, 100.0, 0.02);
  EXPECT_DOUBLE_EQ(speed.next(111.0, 110.0, 90.0, 0.02), 500.0);
  EXPECT_DOUBLE_EQ(speed.next(111.0, 111.0, 108.0, 0.02), 150.0);  // it arrives in this tick
  EXPECT_DOUBLE_EQ(speed.next(111.0, 111.0, 111.0, 0.02), 0.0);
}

// An object in the way: when it is gone, the servo is as fast as it was commanded, not faster.
TEST(GoalSpeed, NeverExceedsThatOfTheGoals) {
  GoalSpeed speed;
  speed.next(110.0, 100.0, 100.0, 0.02);
  for (int i = 0; i < 100; ++i) EXPECT_DOUBLE_EQ(speed.next(110.0, 110.0, 10.0, 0.02), 500.0);
}

}  // namespace
}  // namespace somato::devices
