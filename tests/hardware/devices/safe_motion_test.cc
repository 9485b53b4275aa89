#include "hardware/devices/safe_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/support/no_malloc.h"
#include "somato/core/random.h"

namespace somato::devices {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

ServoSettings servo(double least, double most, double fastest) {
  ServoSettings settings;
  settings.name = "servo";
  settings.zero = 1500.0;
  settings.scale = -10.0;
  settings.least = least;
  settings.most = most;
  settings.fastest = fastest;
  return settings;
}

TEST(SafeMotion, MovesAtItsSpeedAndArrivesExactly) {
  SafeMotion motion(std::vector{servo(-30.0, 30.0, 60.0)});
  motion.begin(std::vector{0.0});
  motion.set_targets(std::vector{3.1});
  EXPECT_DOUBLE_EQ(motion.advance(0.02)[0], 1500.0 - 10.0 * 1.2);
  EXPECT_DOUBLE_EQ(motion.advance(0.02)[0], 1500.0 - 10.0 * 2.4);
  EXPECT_DOUBLE_EQ(motion.advance(0.02)[0], 1500.0 - 10.0 * 3.1);
  EXPECT_EQ(motion.positions()[0], 3.1);
}

TEST(SafeMotion, SendsNothingToAServoOfUnknownPositionUntilItIsSwitchedOn) {
  SafeMotion motion(std::vector{servo(-30.0, 30.0, 60.0), servo(0.0, 10.0, 60.0)});
  motion.begin(std::vector{kNaN, 5.0});
  EXPECT_TRUE(std::isnan(motion.advance(0.02)[0]));
  EXPECT_EQ(motion.positions()[0], -30.0);  // its resting position
  motion.switch_on(0);
  EXPECT_EQ(motion.advance(0.02)[0], 1800.0);
}

TEST(SafeMotion, HoldsWhereItIs) {
  SafeMotion motion(std::vector{servo(-30.0, 30.0, 60.0)});
  motion.begin(std::vector{0.0});
  motion.set_targets(std::vector{20.0});
  motion.advance(0.1);
  motion.note_sent();
  motion.hold();
  motion.advance(1.0);
  EXPECT_EQ(motion.positions()[0], 6.0);
}

// A bus that waited for an answer has not sent the positions since.
TEST(SafeMotion, HoldsAtThePositionThatWasSentLast) {
  SafeMotion motion(std::vector{servo(-30.0, 30.0, 60.0)});
  motion.begin(std::vector{0.0});
  motion.set_targets(std::vector{20.0});
  motion.advance(0.1);
  motion.note_sent();
  motion.advance(0.1);
  motion.hold();
  EXPECT_EQ(motion.positions()[0], 6.0);
  motion.advance(1.0);
  EXPECT_EQ(motion.positions()[0], 6.0);
}

// The commands are 10^6 targets, of which a part is not finite or far outside.
TEST(SafeMotion, StaysWithinItsLimitsWhateverIsCommanded) {
  const std::vector servos{servo(-30.0, 30.0, 60.0), servo(0.0, 140.0, 148.9)};
  SafeMotion motion(servos);
  motion.begin(std::vector{-29.0, kNaN});
  motion.switch_on(1);
  Random random(1, Stream::kHandSensors);
  std::vector<double> targets(2);
  std::vector<double> before(motion.positions().begin(), motion.positions().end());
  std::size_t outside = 0;
  std::size_t too_fast = 0;
  for (int i = 0; i < 1000000; ++i) {
    for (double& target : targets) {
      const double kind = random.uniform();
      target = kind < 0.1   ? kNaN
               : kind < 0.2 ? kInfinity
               : kind < 0.3 ? -kInfinity
               : kind < 0.4 ? 1e300 * (random.uniform() - 0.5)
                            : 400.0 * (random.uniform() - 0.5);
    }
    motion.set_targets(targets);
    const double seconds = 0.02 * random.uniform();
    const std::span<const double> on_bus = motion.advance(seconds);
    for (std::size_t servo = 0; servo < 2; ++servo) {
      const double position = servos[servo].from_bus(on_bus[servo]);
      const double slack = 1e-9;
      if (!(position >= servos[servo].least - slack && position <= servos[servo].most + slack)) {
        ++outside;
      }
      if (!(std::abs(position - before[servo]) <= servos[servo].fastest * seconds + slack)) {
        ++too_fast;
      }
      before[servo] = position;
    }
  }
  EXPECT_EQ(outside, 0U);
  EXPECT_EQ(too_fast, 0U);
}

TEST(SafeMotion, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "sanitizers bring their own operator new";
  SafeMotion motion(std::vector{servo(-30.0, 30.0, 60.0)});
  const std::vector position{0.0};
  const std::vector target{9.0};
  const testing::AllocationCounter counter;
  motion.begin(position);
  motion.set_targets(target);
  motion.advance(0.02);
  motion.hold();
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace somato::devices
