// Servos that do not do what they are commanded, on each bus: when the body stops, what it says,
// and what the servos do until then.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardware/support/every_bus.h"
#include "hardware/support/faulty_fingers.h"
#include "hardware/support/lent_lines.h"

namespace somato::devices {
namespace {

using testing::faulty_device;
using testing::FaultyFingers;
using testing::Outcome;
using testing::outcome_of;

constexpr double kHold = 0.5;  // s, of the device

class ServoFaults : public ::testing::TestWithParam<BusKind> {
 protected:
  bool measures() const { return traits_of(GetParam()).measures; }

  void expect_said(const Outcome& outcome, const std::string& what) const {
    EXPECT_EQ(outcome.error.kind, ErrorKind::kData);
    EXPECT_NE(outcome.error.what.find(what), std::string::npos) << outcome.error.what;
  }

  FaultyFingers fingers_{faulty_device(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Buses, ServoFaults, ::testing::ValuesIn(testing::every_bus()),
                         testing::name_of_bus);

// An SSC-32 does not know where its servos are.
TEST_P(ServoFaults, AServoThatIsStuckStopsTheBody) {
  fingers_.hand.stops = {0.0, 90.0};
  const Outcome outcome = outcome_of(fingers_, [] {});
  EXPECT_EQ(outcome.stopped, measures());
  if (!measures()) return;
  expect_said(outcome, "the servo 'thumb' does not move: it has been at ");
  // It was sent from 0 to 60 deg at 60 deg/s, 0.4 s before; 6 deg are permitted, for 0.5 s.
  EXPECT_NEAR(outcome.after, 0.1 + 0.5 - 0.4 + kHold, 0.08);
  EXPECT_TRUE(fingers_.are_off());
}

// The thumb stops half way, as on an object.
TEST_P(ServoFaults, AnObjectStopsAFingerAndNotTheBody) {
  fingers_.hand.stops = {30.0, 90.0};
  EXPECT_FALSE(outcome_of(fingers_, [] {}).stopped);
}

// Nothing could hold it, so that all are off at once.
TEST_P(ServoFaults, AServoThatDriftsAwayIsSwitchedOff) {
  if (!measures()) return;
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.hand.drifts = {0.0, -176.0}; });
  ASSERT_TRUE(outcome.stopped);
  expect_said(outcome, "the servo 'index' ");
  // 9 deg take 51 ms; then the stop is due.
  EXPECT_LT(outcome.after, 9.0 / 176.0 + 0.05 + 0.02);
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(ServoFaults, AServoBeyondItsLimitsIsSwitchedOff) {
  if (!measures()) return;
  fingers_.device.file.safety.deviation = 1.0;
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.hand.drifts = {0.0, 400.0}; });
  ASSERT_TRUE(outcome.stopped);
  expect_said(outcome, "the servo 'index' is at ");
  expect_said(outcome, "outside its limits, 0 to 90");
  EXPECT_LT(outcome.after, 0.3);
  EXPECT_TRUE(fingers_.are_off());
}

// The temperatures of Dynamixel servos are read five times in a second.
TEST_P(ServoFaults, AHotServoStopsTheBody) {
  if (!fingers_.has_chain()) return;
  const Outcome outcome = outcome_of(fingers_, [&] { fingers_.heat(1, 130); });
  ASSERT_TRUE(outcome.stopped);
  expect_said(outcome, "the servo 'index' has a temperature of 130 degrees Celsius, above 70");
  EXPECT_LT(outcome.after, kHold + (GetParam() == BusKind::kDynamixel ? 0.4 : 0.12));
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(ServoFaults, AWarmServoIsNoFault) {
  if (!fingers_.has_chain()) return;
  EXPECT_FALSE(outcome_of(fingers_, [&] { fingers_.heat(1, 70); }).stopped);
}

// The horn of the finger is half its range away from where the file says. An SSC-32 cannot know.
TEST_P(ServoFaults, ACalibrationOfAnotherHandIsRefusedAndMovesNothing) {
  if (!measures()) return;
  DeviceFile other = fingers_.device.file;
  ServoSettings& thumb = other.servos[0];
  thumb.zero += thumb.scale * 0.5 * (thumb.most - thumb.least);
  const auto before = fingers_.hand.state().positions;
  const auto refused = DeviceBody::start(other, fingers_.device.lines);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(refused.error().what.find("outside its limits, 0 to 60"), std::string::npos)
      << refused.error().what;
  EXPECT_TRUE(fingers_.are_off());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(fingers_.hand.state().positions[i], before[i], testing::kResolution);
  }
}

// As a program that is stopped and continued: the clock has gone on, and nothing was read.
TEST_P(ServoFaults, AProgramThatIsHeldUpStopsTheBody) {
  class HeldUp : public testing::LentLines {
   public:
    using LentLines::LentLines;
    Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override {
      auto count = LentLines::write(line, bytes);
      const double until = now() + std::exchange(seconds, 0.0);
      while (now() < until) LentLines::wait(until);
      return count;
    }
    double seconds = 0.0;
  };
  HeldUp lines(fingers_.device.lines);
  const auto body = DeviceBody::start(fingers_.device.file, lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->command(std::array{60.0, 90.0}));
  lines.seconds = 0.3;  // a busy computer
  ASSERT_TRUE((*body)->step(0.2));
  lines.seconds = 3.0;
  const auto stepped = (*body)->step(0.2);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().kind, ErrorKind::kSystem);
  EXPECT_NE(stepped.error().what.find("the program was held up for 3.0 s"), std::string::npos)
      << stepped.error().what;
  EXPECT_FALSE((*body)->is_on());
  EXPECT_TRUE(fingers_.are_off());
}

// Answers arrive meanwhile: a command after each of them would fill the line, and delay the last
// command, which switches the servos off.
TEST_P(ServoFaults, AStoppedHandHoldsWithOneCommandInAPeriod) {
  class Counting : public testing::LentLines {
   public:
    using LentLines::LentLines;
    Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override {
      writes += bytes.empty() ? 0 : 1;
      return LentLines::write(line, bytes);
    }
    std::size_t writes = 0;
  };
  Counting lines(fingers_.device.lines);
  const auto body = DeviceBody::start(fingers_.device.file, lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->step(0.2));
  fingers_.sensor_line().hung_up = true;
  lines.writes = 0;
  const double before = lines.now();
  ASSERT_FALSE((*body)->step(1.0));
  EXPECT_NEAR(lines.now() - before, kHold, 0.05);
  // A command, and with SCS servos the request of the second state; then the servos are off.
  const double periods = kHold / fingers_.device.file.settings.period;
  EXPECT_GE(lines.writes, static_cast<std::size_t>(periods));
  EXPECT_LE(lines.writes, static_cast<std::size_t>(2.0 * periods) + 5);
}

// The servos of an SSC-32 jump to their resting positions one after the other when it starts.
TEST_P(ServoFaults, AStartThatIsInterruptedSwitchesThemOffAtOnce) {
  if (measures()) return;
  auto& lines = fingers_.device.lines;
  double jumped = 0.0;
  const auto should_continue = [&] {
    if (jumped == 0.0 && fingers_.servos().driven_position(0)) jumped = lines.now();
    return jumped == 0.0;
  };
  const auto started = DeviceBody::start(fingers_.device.file, lines, {}, should_continue);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::kInterrupted);
  EXPECT_GT(jumped, 0.0);
  EXPECT_LT(lines.now() - jumped, 0.03);
  EXPECT_FALSE(fingers_.servos().driven_position(1)) << "the second has not jumped";
  EXPECT_TRUE(fingers_.are_off());
}

// A view waits between two steps, for as long as a person likes.
TEST_P(ServoFaults, AWaitThatIsExpectedIsNoFault) {
  const auto body = DeviceBody::start(fingers_.device.file, fingers_.device.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  ASSERT_TRUE((*body)->step(0.2));
  const auto hold_up = [&] {
    const double until = fingers_.device.lines.now() + 3.0;
    while (fingers_.device.lines.now() < until) fingers_.device.lines.wait(until);
  };
  hold_up();
  (*body)->expect_pause();
  EXPECT_TRUE((*body)->step(0.2));
  hold_up();
  EXPECT_FALSE((*body)->step(0.2)) << "the wait before was the one that was expected";
}

// Twelve servos that are read one after the other: the bus is as silent as one with two.
TEST(ServoFaultsOfScs, SilenceIsNoticedAsSoonForManyServosAsForFew) {
  std::vector<double> after;
  for (const std::size_t servos : {2U, 12U}) {
    DeviceFile file = faulty_device(BusKind::kScs);
    auto hand = testing::two_fingers(file);
    for (std::size_t i = 2; i < servos; ++i) {
      ServoSettings more = file.servos[0];
      more.name = "finger " + std::to_string(i);
      more.channel = 10 + i;
      file.servos.push_back(more);
      hand->add_servo({more.name, "deg", more.least, more.most, 600.0}, 0.0);
    }
    file.servo_line->baud = 1000000;
    FaultyFingers fingers(file, std::move(hand));
    const auto body = DeviceBody::start(file, fingers.device.lines);
    ASSERT_TRUE(body) << to_string(body.error());
    ASSERT_TRUE((*body)->step(0.5));
    fingers.servo_line().silent = true;
    const double moment = fingers.device.lines.now();
    ASSERT_FALSE((*body)->step(5.0));
    after.push_back(fingers.device.lines.now() - moment - kHold);
  }
  EXPECT_LT(after[0], 0.15);
  EXPECT_NEAR(after[1], after[0], 0.03);
}

// One of them has lost its power; the others answer.
TEST(ServoFaultsOfScs, OneServoThatFallsSilentIsNoticed) {
  FaultyFingers fingers(faulty_device(BusKind::kScs));
  const Outcome outcome = outcome_of(fingers, [&] { fingers.chain().set_silent(1, true); });
  ASSERT_TRUE(outcome.stopped);
  EXPECT_NE(outcome.error.what.find("the servo 'index' gave no answer"), std::string::npos);
  EXPECT_LT(outcome.after, kHold + 0.3);
}

}  // namespace
}  // namespace somato::devices
