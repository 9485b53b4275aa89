#include "hardware/device_files/calibration.h"

#include <gtest/gtest.h>

namespace somato::devices {
namespace {

ServoSettings wrist() {
  ServoSettings servo;
  servo.name = "wrist";
  servo.zero = 1500.0;
  servo.scale = 10.0;
  servo.least = -40.0;
  servo.most = 40.0;
  return servo;
}

TEST(Calibration, FindsZeroAndScaleAndKeepsTheLimitsOnTheBus) {
  Calibration calibration(wrist());
  calibration.set_zero(1520.0);
  ASSERT_TRUE(calibration.set_position(1970.0, 50.0));
  const ServoSettings found = calibration.servo();
  EXPECT_DOUBLE_EQ(found.scale, 9.0);
  EXPECT_DOUBLE_EQ(found.on_bus(found.least), 1100.0);
  EXPECT_DOUBLE_EQ(found.on_bus(found.most), 1900.0);
}

TEST(Calibration, ExchangesTheLimitsOfAServoThatTurnsTheOtherWay) {
  Calibration calibration(wrist());
  ASSERT_TRUE(calibration.set_position(1700.0, -20.0));
  EXPECT_DOUBLE_EQ(calibration.servo().scale, -10.0);
  EXPECT_DOUBLE_EQ(calibration.servo().least, -40.0);
  EXPECT_DOUBLE_EQ(calibration.servo().on_bus(-40.0), 1900.0);
}

TEST(Calibration, RefusesAScaleFromZero) {
  Calibration calibration(wrist());
  EXPECT_FALSE(calibration.set_position(1500.0, 10.0));
  EXPECT_FALSE(calibration.set_position(1600.0, 0.0));
}

TEST(Calibration, WritesTheServoOnly) {
  const std::string text =
      "name = \"hand\"\nexplore = \"closing\"\n[servos]\nbus = \"ssc32\"\nport = \"p\"\n"
      "[servo.wrist]\nchannel = 1\nzero = 1500\nscale = 10\nleast = -40  # careful\nmost = 40\n"
      "[sensor.wrist]\nfrom = \"driver\"\nservos = [\"wrist\"]\n";
  Calibration calibration(parse_device_file(text, "d")->servos[0]);
  calibration.set_least(1200.0);
  calibration.set_most(1801.0);
  const auto changed = calibration.in_text(text, "d");
  ASSERT_TRUE(changed) << to_string(changed.error());
  std::string expected = text;
  expected.replace(expected.find("-40"), 3, "-30");
  expected.replace(expected.find("most = 40"), 9, "most = 30.1");
  EXPECT_EQ(*changed, expected);
  calibration.set_most(2600.0);  // no pulse is so long
  EXPECT_FALSE(calibration.in_text(text, "d"));
}

TEST(Calibration, MovesOneServoSlowlyOverTheWholeBus) {
  const auto file = own_device_file("lucs3");
  const auto one = one_servo(*file, "thumb_distal");
  ASSERT_TRUE(one);
  ASSERT_EQ(one->servos.size(), 1U);
  const ServoSettings& servo = one->servos[0];
  EXPECT_DOUBLE_EQ(servo.on_bus(servo.least), 500.0);
  EXPECT_DOUBLE_EQ(servo.on_bus(servo.most), 2500.0);
  EXPECT_DOUBLE_EQ(servo.fastest, 10.0);
  EXPECT_EQ(servo.resting(), 0.0);
  EXPECT_EQ(one_servo(*file, "thumb_dstal").error().advice, "did you mean 'thumb_distal'?");
}

}  // namespace
}  // namespace somato::devices
