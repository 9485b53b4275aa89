// Faults of a device while it moves, on each bus: when the body stops, what it says,
// and what its servos did until then.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardware/devices/device_io.h"
#include "hardware/support/every_bus.h"
#include "hardware/support/faulty_fingers.h"
#include "somato/core/random.h"

namespace somato::devices {
namespace {

using testing::FaultyFingers;
using testing::kResolution;
using testing::Outcome;
using testing::outcome_of;

DeviceFile device_file(BusKind bus, FrameFormat format = FrameFormat::kFrames) {
  return testing::faulty_device(bus, format);
}

// The body moves to and fro for some seconds and continues.
void expect_continues(FaultyFingers& fingers, const std::function<void()>& fault) {
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  for (int i = 0; i < 10; ++i) {
    const double target = i % 2 == 0 ? 60.0 : 0.0;
    ASSERT_TRUE((*body)->command(std::array{target, target}));
    fault();
    const auto stepped = (*body)->step(0.5);
    ASSERT_TRUE(stepped) << to_string(stepped.error());
  }
}

// The recording holds what arrives.
void expect_stuck_and_dead_taxels(FaultyFingers& fingers) {
  const auto body = DeviceBody::start(fingers.device.file, fingers.device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->command(std::array{30.0, 45.0}));
  ASSERT_TRUE((*body)->step(1.5));
  EXPECT_NEAR((*body)->state().readings[0](0, 0), 0.5F, 0.02F);
  fingers.sensors().stick(0);
  fingers.sensors().kill(1);
  ASSERT_TRUE((*body)->command(std::array{60.0, 90.0}));
  ASSERT_TRUE((*body)->step(1.5));
  EXPECT_NEAR((*body)->state().readings[0](0, 0), 0.5F, 0.02F);
  EXPECT_EQ((*body)->state().readings[0](0, 1), 0.0F);
  EXPECT_LE(fingers.beyond(), kResolution);
}

// Anything that a faulty program may command, mostly impossible.
double random_target(Random& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::array targets{std::numeric_limits<double>::quiet_NaN(),
                           kInfinity,
                           -kInfinity,
                           1e300 * (random.uniform() - 0.5),
                           400.0 * (random.uniform() - 0.5),
                           90.0 * random.uniform(),
                           90.0 * random.uniform()};
  return targets.at(static_cast<std::size_t>(random.uniform() * targets.size()));
}

class DeviceFaults : public ::testing::TestWithParam<BusKind> {
 protected:
  // Seconds until silence is a fault: three periods; a lost answer of an SCS servo is awaited
  // twice, and an SSC-32 is given time to resynchronize.
  static double patience() {
    if (GetParam() == BusKind::kSsc32) return 0.2;
    return GetParam() == BusKind::kScs ? 0.1 : 0.06;
  }

  FaultyFingers fingers_{device_file(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Buses, DeviceFaults, ::testing::ValuesIn(testing::every_bus()),
                         testing::name_of_bus);

TEST_P(DeviceFaults, AHangUpInAMovementIsNoticedWithin100Milliseconds) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.servo_line().hung_up = true; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.kind, ErrorKind::kSystem);
  EXPECT_EQ(outcome.error.what, "the line has hung up");
  EXPECT_NE(outcome.error.advice.find("check the cable"), std::string::npos);
  EXPECT_LT(outcome.after, 0.1);
}

TEST_P(DeviceFaults, SilenceIsNoticedAfterThreeMissedPolls) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.servo_line().silent = true; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_NE(outcome.error.what.find("gave no answer for"), std::string::npos);
  EXPECT_NE(outcome.error.advice.find("check the cable"), std::string::npos);
  EXPECT_EQ(outcome.error.where, "servo port");
  EXPECT_GE(outcome.after, patience() + 0.5 - 0.04);
  EXPECT_LE(outcome.after, patience() + 0.5 + 0.06);
  EXPECT_TRUE(fingers_.are_off());
}

// The bus of an SSC-32 sends nothing while it waits for an answer: what it would have sent since is
// not made up for after the stop.
TEST_P(DeviceFaults, NothingMovesWhileAStoppedHandHolds) {
  const ServoSettings& servo = fingers_.device.file.servos[1];
  double moment = std::numeric_limits<double>::infinity();
  double least = servo.most;
  double most = servo.least;
  fingers_.device.at = [&, before = fingers_.device.at](double now) {
    before(now);
    const auto driven = fingers_.servos().driven_position(1);
    if (now < moment + patience() + 0.05 || !driven) return;
    least = std::min(least, servo.from_bus(*driven));
    most = std::max(most, servo.from_bus(*driven));
  };
  const Outcome outcome = outcome_of(fingers_, [&] {
    moment = fingers_.device.lines.now();
    fingers_.servo_line().silent = true;
  });
  ASSERT_TRUE(outcome.stopped);
  ASSERT_GT(most, 20.0) << "it was on its way to 90 deg";
  EXPECT_LT(most, 80.0);
  EXPECT_LT(most - least, 1.0);
}

TEST_P(DeviceFaults, GarbageIsSkipped) {
  expect_continues(fingers_, [&] {
    fingers_.servo_line().garbage = {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0xFF, 0x7F, 0x55, 'Q', '\r'};
    fingers_.sensor_line().garbage = {0x00, 0x05, 0xFF, '1', ',', '\n', 0x00};
  });
  EXPECT_LE(fingers_.beyond(), kResolution);
}

// An SSC-32 has no checksum, so that it may drive a servo anywhere: what the host sends is right.
TEST_P(DeviceFaults, OneByteInAThousandMayBeFlipped) {
  expect_continues(fingers_, [&] {
    fingers_.servo_line().flipped = 0.001;
    fingers_.sensor_line().flipped = 0.001;
  });
  if (traits_of(GetParam()).measures) {
    EXPECT_LE(fingers_.beyond(), kResolution);
  }
}

// The line of an SSC-32 has two wires and no echo: there it is as good as silence.
TEST_P(DeviceFaults, AnEchoIsNoAnswer) {
  if (!traits_of(GetParam()).measures) {
    EXPECT_TRUE(outcome_of(fingers_, [&] { fingers_.servo_line().echo = true; }).stopped);
    return;
  }
  expect_continues(fingers_, [&] { fingers_.servo_line().echo = true; });
  EXPECT_LE(fingers_.beyond(), kResolution);
}

// A controller whose supply fails for a moment has forgotten where its servos are, and drives none.
TEST_P(DeviceFaults, ABrownOutStopsTheBody) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.servos().restart(); });
  ASSERT_TRUE(outcome.stopped) << "the servos are off, and the body continues";
  EXPECT_LT(outcome.after, 0.5 + 0.2);
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(DeviceFaults, AnOverloadStopsTheBodyUntilAReboot) {
  if (!fingers_.has_chain()) {
    // It neither measures the load of its servos nor restarts them.
    DeviceIo io(fingers_.device.file, fingers_.device.lines);
    const auto refused = io.reboot();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().advice, "switch their supply off and on");
    return;
  }
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.overload(1); });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_NE(outcome.error.what.find("the servo 'index' reports the hardware error"),
            std::string::npos);
  EXPECT_NE(outcome.error.advice.find("--reboot"), std::string::npos);
  EXPECT_TRUE(fingers_.are_off());
  const auto again = DeviceBody::start(fingers_.device.file, fingers_.device.lines);
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().advice.find("--reboot"), std::string::npos);
  DeviceIo io(fingers_.device.file, fingers_.device.lines);
  const auto rebooted = io.reboot();
  ASSERT_TRUE(rebooted) << to_string(rebooted.error());
  const auto started = DeviceBody::start(fingers_.device.file, fingers_.device.lines);
  EXPECT_TRUE(started) << to_string(started.error());
}

TEST_P(DeviceFaults, StuckAndDeadTaxelsGiveWhatTheyGive) {
  expect_stuck_and_dead_taxels(fingers_);
}

TEST_P(DeviceFaults, ASlowLineStopsTheBody) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.servo_line().slowness = 200.0; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.kind, ErrorKind::kSystem);
  EXPECT_EQ(outcome.error.where, "servo port");
  EXPECT_LT(outcome.after, 1.0);
}

TEST_P(DeviceFaults, RandomCommandsDriveNoServoBeyondItsLimits) {
  const auto body = DeviceBody::start(fingers_.device.file, fingers_.device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  Random random(1, Stream::kHandSensors);
  std::size_t accepted = 0;
  for (int i = 0; i < 5000; ++i) {
    const double thumb = random_target(random);
    const double index = random_target(random);
    const bool is_possible = thumb >= 0.0 && thumb <= 60.0 && index >= 0.0 && index <= 90.0;
    ASSERT_EQ((*body)->command(std::array{thumb, index}).has_value(), is_possible);
    accepted += is_possible ? 1 : 0;
    const auto stepped = (*body)->step(0.02);
    ASSERT_TRUE(stepped) << to_string(stepped.error());
  }
  EXPECT_GT(accepted, 200U);
  EXPECT_LE(fingers_.beyond(), kResolution);
}

TEST_P(DeviceFaults, SensorsThatHangUpStopTheBodyWhichHoldsAndRelaxes) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().hung_up = true; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.what, "the line has hung up");
  EXPECT_GE(outcome.after, 0.5);
  EXPECT_LT(outcome.after, 0.5 + 0.1);
  EXPECT_TRUE(fingers_.are_off());
}

// On the sensors' side the format matters, not the bus.
class SensorFaults : public ::testing::TestWithParam<FrameFormat> {
 protected:
  FaultyFingers fingers_{device_file(BusKind::kDynamixel, GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Formats, SensorFaults, ::testing::ValuesIn(testing::every_format()),
                         [](const auto& bus) { return choice_name(bus.param); });

TEST_P(SensorFaults, SilenceForThreePeriodsStopsTheBody) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().silent = true; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.what, "no valid sensor frame arrived for 3 periods");
  EXPECT_EQ(outcome.error.where, "sensor port");
  EXPECT_NEAR(outcome.after, 0.06 + 0.5, 0.06);
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(SensorFaults, AHangUpIsNoticedWithin100Milliseconds) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().hung_up = true; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.what, "the line has hung up");
  EXPECT_LT(outcome.after, 0.1 + 0.5);
  EXPECT_TRUE(fingers_.are_off());
}

// A checked frame is right or missing. Without a checksum a value may be wrong, and then the body
// stops if it is above the limit.
TEST_P(SensorFaults, OneByteInAThousandMayBeFlipped) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().flipped = 0.001; });
  if (!outcome.stopped) return;
  EXPECT_NE(GetParam(), FrameFormat::kFrames);
  EXPECT_NE(outcome.error.what.find("above the limit"), std::string::npos) << outcome.error.what;
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(SensorFaults, StuckAndDeadTaxelsGiveWhatTheyGive) {
  expect_stuck_and_dead_taxels(fingers_);
}

TEST_P(SensorFaults, NothingButGarbageStopsTheBody) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().flipped = 0.5; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(SensorFaults, ASlowLineStopsTheBody) {
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.sensor_line().slowness = 500.0; });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.error.what, "no valid sensor frame arrived for 3 periods");
}

TEST_P(SensorFaults, ABoardThatRestartsIsReadOn) {
  expect_continues(fingers_, [&] { fingers_.sensors().restart(); });
}

// Without a checksum a wrong value may arrive; one above the limit stops the body.
TEST_P(SensorFaults, FramesAfterGarbageAreRead) {
  expect_continues(fingers_, [&] {
    fingers_.sensor_line().garbage = {0x00, 0x05, 0xFF, '1', ',', '\n', 0x00, 0x0D};
  });
}

}  // namespace
}  // namespace somato::devices
