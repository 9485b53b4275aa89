#include "bodies/sensors/potentiometer.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato::detail {
namespace {

TEST(StickPosition, IsKnownByTheCountsOfItsPotentiometer) {
  HardnessProbeParameters parameters;
  parameters.stroke = 8.0;
  parameters.potentiometer_bits = 10;
  EXPECT_EQ(stick_position(0.0, parameters), 0.0);
  EXPECT_EQ(stick_position(1023.0, parameters), 8.0);
  EXPECT_DOUBLE_EQ(stick_position(341.0, parameters).value(), 8.0 / 3.0);
  for (const double counts : {-1.0, 1024.0, double{INFINITY}, double{NAN}}) {
    EXPECT_FALSE(stick_position(counts, parameters));
  }
}

// 8 bits over 51 mm are steps of 0.2 mm; the stick at 0 reads a fifth of 255.
TEST(Potentiometer, ReadsItsPathFromItsOffsetOn) {
  HardnessProbeParameters parameters;
  parameters.potentiometer_bits = 8;
  parameters.potentiometer_path = 51.0;
  parameters.potentiometer_offset = 0.2;
  parameters.potentiometer_noise = 0.4;
  const Potentiometer potentiometer(parameters, 1);
  EXPECT_EQ(potentiometer.read(0.0, 0.0), 51.0F);
  EXPECT_EQ(potentiometer.read(2.0, 0.0), 61.0F);
  EXPECT_EQ(potentiometer.read(2.0, -3.0), 55.0F);
  EXPECT_EQ(potentiometer.read(1000.0, 0.0), 255.0F);
  EXPECT_EQ(potentiometer.read(-1000.0, 0.0), 0.0F);
  EXPECT_NEAR(stick_position(61.0, parameters).value(), 2.0, 1e-12);
  EXPECT_EQ(stick_position(0.0, parameters), 0.0);     // below the stick's stroke
  EXPECT_EQ(stick_position(255.0, parameters), 10.0);  // above it
}

TEST(Potentiometer, DiffersFromTheStickByTheSameDistanceDuringAPress) {
  HardnessProbeParameters parameters;
  const Potentiometer exact(parameters, 1);
  parameters.press_spread = 0.5;
  const Potentiometer first(parameters, 1);
  const Potentiometer second(parameters, 2);
  const float away = first.read(4.0, 0.0) - exact.read(4.0, 0.0);
  EXPECT_NE(away, 0.0F);
  EXPECT_NEAR(first.read(6.0, 0.0) - exact.read(6.0, 0.0), away, 1.0);
  EXPECT_NE(second.read(4.0, 0.0), first.read(4.0, 0.0));
}

}  // namespace
}  // namespace somato::detail
