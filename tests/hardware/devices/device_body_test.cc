#include "hardware/devices/device_body.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/support/no_malloc.h"
#include "bodies/support/fake_hand.h"
#include "hardware/boards/dynamixel_servos.h"
#include "hardware/support/emulated_device.h"
#include "somato/bodies/explore_by.h"

namespace somato::devices {
namespace {

using testing::EmulatedDevice;

constexpr const char* kDevice = R"(name = "two fingers"
explore = "closing"
[servos]
bus = "dynamixel"
port = "port"
baud = 1000000
[servo.thumb]
channel = 1
zero = 2048
scale = 11.375
least = 0
most = 60
fastest = 60
[servo.index]
channel = 2
zero = 2048
scale = -11.375
least = 0
most = 90
fastest = 90
[sensor.joints]
unit = "deg"
from = "servos"
servos = ["thumb", "index"]
[sensor.touch]
unit = "mA"
from = "currents"
servos = ["thumb", "index"]
[safety]
sensor = "touch"
limit = 300
hold = 0.5
)";

DeviceFile file() {
  return *parse_device_file(kDevice, "d.toml");
}

// Two servos that follow their targets, and a sensor of touch that is pressed from outside.
std::unique_ptr<FakeHand> two_fingers(const float& force) {
  auto hand = std::make_unique<FakeHand>("two fingers");
  hand->add_servo({"thumb", "deg", 0.0, 60.0, 600.0}, 0.0);
  hand->add_servo({"index", "deg", 0.0, 90.0, 900.0}, 0.0);
  ChannelDescription touch;
  touch.name = "touch";
  touch.element_names = {"thumb_1", "index_1"};
  hand->add_sensor(
      touch, [&force](const std::vector<double>&) { return std::vector<float>{0.0F, force}; });
  return hand;
}

struct Fingers {
  float force = 0.0F;
  EmulatedDevice device{file(), two_fingers(force)};

  emulation::DynamixelServos& servos() {
    return dynamic_cast<emulation::DynamixelServos&>(device.body.servos());
  }
  bool is_off(std::size_t servo) { return !servos().driven_position(servo).has_value(); }
};

TEST(DeviceBody, MovesItsServosAtTheirSpeedAndReadsThem) {
  Fingers fingers;
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  EXPECT_EQ((*body)->state().time, 0.0);
  ASSERT_TRUE((*body)->command(std::array{30.0, 90.0}));
  ASSERT_TRUE((*body)->step(0.25));
  EXPECT_NEAR((*body)->state().positions[0], 15.0, 1.5);  // one tick early or late
  ASSERT_TRUE((*body)->step(1.0));
  EXPECT_EQ((*body)->state().positions, (std::vector{30.0, 90.0}));
  EXPECT_DOUBLE_EQ((*body)->state().time, 1.25);
  const Matrix<float>& joints = (*body)->state().readings[0];
  EXPECT_NEAR(joints(0, 0), 30.0F, 0.1F);  // a step is 0.09 deg
  EXPECT_NEAR(joints(0, 1), 90.0F, 0.1F);
}

// A skin of 1 kHz beside servos that are driven at 100 Hz.
constexpr const char* kFastSkin = R"(name = "fast skin"
explore = "holding"
period = 0.01
[servos]
bus = "ssc32"
port = "servos"
[servo.finger]
channel = 0
zero = 1000
scale = 10
least = 0
most = 60
fastest = 60
[frames]
port = "sensors"
baud = 1000000
elements = 2
rate = 1000
keep = "every"
[sensor.joint]
unit = "deg"
from = "driver"
servos = ["finger"]
[sensor.touch]
from = "frames"
first = 1
gain = 2.0
)";

TEST(DeviceBody, KeepsEveryFrameOfASkinWithItsTime) {
  auto hand = std::make_unique<FakeHand>("fast skin");
  hand->add_servo({"finger", "deg", 0.0, 60.0, 600.0}, 0.0);
  ChannelDescription touch;
  touch.name = "touch";
  touch.element_names = {"a"};
  hand->add_sensor(touch, [](const auto&) { return std::vector<float>{3.0F}; });
  EmulatedDevice device(*parse_device_file(kFastSkin, "d.toml"), std::move(hand));
  const auto body = DeviceBody::start(device.file, device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->step(0.05));  // Moves towards the grasp, and is not recorded.
  const auto held = explore_by_holding(**body, 0.25, 0.01);
  ASSERT_TRUE(held) << to_string(held.error());
  EXPECT_TRUE(validate(Recording{{*held}}));
  EXPECT_EQ(held->channels[0].frames.rows(), 20U);
  const Channel& skin = held->channels[1];
  ASSERT_NEAR(static_cast<double>(skin.frames.rows()), 200.0, 1.0);
  EXPECT_EQ(skin.frames, Matrix<float>(skin.frames.rows(), 1, 3.0F));
  EXPECT_NEAR(skin.times.front(), 0.051, 0.0011);
  for (std::size_t i = 1; i < skin.times.size(); ++i) {
    EXPECT_NEAR(skin.times[i] - skin.times[i - 1], 0.001, 1e-5) << i;
  }
}

TEST(DeviceBody, DiscardsTheFramesOfAPause) {
  auto hand = std::make_unique<FakeHand>("fast skin");
  hand->add_servo({"finger", "deg", 0.0, 60.0, 600.0}, 0.0);
  ChannelDescription touch;
  touch.name = "touch";
  touch.element_names = {"a"};
  hand->add_sensor(touch, [](const auto&) { return std::vector<float>{3.0F}; });
  EmulatedDevice device(*parse_device_file(kFastSkin, "d.toml"), std::move(hand));
  const auto body = DeviceBody::start(device.file, device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->step(0.05));
  (*body)->expect_pause();
  device.lines.wait(device.lines.now() + 2.0);
  ASSERT_TRUE((*body)->step(0.05));
  const std::vector<double>& times = (*body)->state().times[1];
  ASSERT_NEAR(static_cast<double>(times.size()), 50.0, 1.0);
  EXPECT_GT(times.front(), 0.05);
  EXPECT_LE(times.back(), 0.1 + 1e-9);
  ASSERT_TRUE((*body)->begin());
  EXPECT_EQ((*body)->state().readings[1], Matrix<float>(1, 1, 3.0F));
  EXPECT_TRUE((*body)->state().times.empty());
}

TEST(DeviceBody, RefusesTargetsOutsideOfItsLimits) {
  Fingers fingers;
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  EXPECT_FALSE((*body)->command(std::array{61.0, 0.0}));
  EXPECT_FALSE((*body)->command(std::vector<double>{NAN, 0.0}));
  EXPECT_FALSE((*body)->command(std::vector<double>{0.0, INFINITY}));
}

TEST(DeviceBody, SwitchesItsServosOffAtTheEnd) {
  Fingers fingers;
  {
    const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
    EXPECT_FALSE(fingers.is_off(0));
  }
  fingers.device.lines.wait(fingers.device.lines.now() + 0.01);
  EXPECT_TRUE(fingers.is_off(0));
  EXPECT_TRUE(fingers.is_off(1));
}

TEST(DeviceBody, HoldsAndRelaxesWhenTheForceIsTooLarge) {
  Fingers fingers;
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  ASSERT_TRUE((*body)->command(std::array{0.0, 90.0}));
  ASSERT_TRUE((*body)->step(0.2));
  fingers.force = 3.5F;  // 350 mA
  const double before = fingers.device.lines.now();
  const auto stopped = (*body)->step(5.0);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kData);
  EXPECT_EQ(stopped.error().what, "the sensor gave 350, above the limit of 300");
  EXPECT_EQ(stopped.error().where, "touch");
  EXPECT_NEAR(fingers.device.lines.now() - before, 0.5 + 0.03, 0.04);  // noticed, and held
  EXPECT_NEAR((*body)->state().positions[1], 18.0, 2.0);
  EXPECT_FALSE((*body)->is_on());
  fingers.device.lines.wait(fingers.device.lines.now() + 0.01);
  EXPECT_TRUE(fingers.is_off(1));
  // The periods before the fault, not those in which it holds.
  EXPECT_GE((*body)->history().size(), 11U);
  EXPECT_LE((*body)->history().size(), 14U);
}

TEST(DeviceBody, IsRelaxedAtOnceWhenItIsInterrupted) {
  Fingers fingers;
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  bool should_continue = true;
  (*body)->keep_to({.should_continue = [&] { return should_continue; }});
  ASSERT_TRUE((*body)->step(0.1));
  const double before = fingers.device.lines.now();
  fingers.device.at = [&](double now) { should_continue = now < before + 0.1; };
  const auto stopped = (*body)->step(5.0);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  fingers.device.lines.wait(fingers.device.lines.now() + 0.01);
  EXPECT_TRUE(fingers.is_off(0));
  EXPECT_LT(fingers.device.lines.now() - before, 0.16);
}

TEST(DeviceBody, NoticesAServoWhoseCableIsPulled) {
  Fingers fingers;
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  ASSERT_TRUE((*body)->step(0.3));
  fingers.servos().set_silent(1, true);
  const auto stopped = (*body)->step(5.0);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().what, "the servo 'index' gave no answer for 3 periods");
}

}  // namespace
}  // namespace somato::devices
