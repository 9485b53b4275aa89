#include "hardware/buses/dynamixel_bus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/emulation/dynamixel_servos.h"
#include "hardware/support/board_line.h"
#include "hardware/support/damaged_streams.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::devices {
namespace {

using emulation::DynamixelServos;
using testing::Bytes;
namespace dynamixel_x = wire::dynamixel_x;

constexpr double kLeft = std::numeric_limits<double>::quiet_NaN();  // left as it is

// A bus and its servos with the ids 1, 2, ... at one line.
struct DynamixelHand {
  explicit DynamixelHand(std::size_t count, bool echo = false)
      : servos(made(count), echo), line(servos), exchange(line, 0), bus(declared(count)) {}

  static std::vector<emulation::EmulatedDynamixel> made(std::size_t count) {
    std::vector<emulation::EmulatedDynamixel> all(count);
    for (std::size_t i = 0; i < count; ++i) {
      all[i] = {.id = static_cast<std::uint8_t>(i + 1),
                .position = 1000.0 + 100.0 * static_cast<double>(i),
                .return_delay = 0};
    }
    return all;
  }

  static std::vector<PacketServo> declared(std::size_t count) {
    std::vector<PacketServo> all;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back({static_cast<std::uint8_t>(i + 1), "XC330-M288"});
    }
    return all;
  }

  // One tick; what arrives in its time is received at its end.
  void tick(const std::vector<double>& positions, double seconds = 0.02) {
    const auto bytes = bus.tick(positions, seconds);
    ASSERT_TRUE(exchange.send(bytes));
    exchange.pause(seconds);
    take();
  }

  void take() {
    Bytes bytes(4096);
    const auto count = line.read(0, bytes);
    ASSERT_TRUE(count);
    bus.receive(std::span(bytes).first(*count), line.now());
  }

  DynamixelServos servos;
  testing::BoardLine line;
  wire::Exchange exchange;
  DynamixelBus bus;
};

TEST(DynamixelBus, StartHoldsEveryServoWhereItIs) {
  DynamixelHand hand(3);
  const auto started = hand.bus.start(hand.exchange);
  ASSERT_TRUE(started) << to_string(started.error());
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = 1000.0 + 100.0 * static_cast<double>(i);
    EXPECT_EQ(hand.servos.driven_position(i), place);
    EXPECT_EQ(hand.bus.reports()[i].position, place);
    EXPECT_EQ(hand.bus.reports()[i].error, 0);
    EXPECT_GT(hand.bus.reports()[i].time, 0.0);
  }
  EXPECT_EQ(hand.servos.eeprom_writes(), 0u);
  EXPECT_TRUE(hand.bus.warnings().empty());
  EXPECT_TRUE(hand.bus.reports_states());
}

TEST(DynamixelBus, StartWorksWithAnEchoAndWithServosThatAnswerOnlyPings) {
  DynamixelHand hand(2, true);
  hand.servos.store(0, dynamixel_x::kStatusReturn, 1, 0);
  const auto started = hand.bus.start(hand.exchange);
  ASSERT_TRUE(started) << to_string(started.error());
  EXPECT_EQ(hand.servos.stored(0, dynamixel_x::kStatusReturn, 1), 2u);
}

TEST(DynamixelBus, StartIsNotMisledByALateAnswerOfAnotherServo) {
  DynamixelHand hand(2);
  hand.servos.store(1, dynamixel_x::kReturnDelay, 1, 250);
  Bytes memory(32);
  wire::DynamixelWriter writer(memory);
  writer.read(2, dynamixel_x::kPresentPosition, 3);  // as long as the answer to a ping
  ASSERT_TRUE(hand.exchange.send(writer.written()));
  const auto started = hand.bus.start(hand.exchange);
  EXPECT_TRUE(started) << to_string(started.error());
}

TEST(DynamixelBus, StartWarnsOfSettingsThatItDoesNotChange) {
  DynamixelHand hand(2);
  hand.servos.store(1, dynamixel_x::kReturnDelay, 1, 250);
  hand.servos.store(1, dynamixel_x::kDriveMode, 1, dynamixel_x::kTorqueOnByGoal);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  ASSERT_EQ(hand.bus.warnings().size(), 2u);
  EXPECT_NE(hand.bus.warnings()[0].find("id 2: it waits 500 us"), std::string::npos);
  EXPECT_EQ(hand.servos.eeprom_writes(), 0u);
}

// Returns the error of start() after `change`, and checks that no servo holds.
template <typename Change>
Error dynamixel_start_error(const Change& change) {
  DynamixelHand hand(2);
  change(hand.servos);
  const auto started = hand.bus.start(hand.exchange);
  EXPECT_FALSE(started);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_FALSE(hand.servos.driven_position(i));
  return started ? Error{} : started.error();
}

TEST(DynamixelBus, StartNamesTheServoThatCannotBeUsed) {
  const Error silent = dynamixel_start_error([](auto& servos) { servos.set_silent(1, true); });
  EXPECT_EQ(silent.kind, ErrorKind::kSystem);
  EXPECT_EQ(silent.where, "servo with id 2");
  const Error model = dynamixel_start_error(
      [](auto& servos) { servos.store(1, dynamixel_x::kModelNumber, 2, 1200); });
  EXPECT_EQ(model.kind, ErrorKind::kData);
  EXPECT_EQ(model.what, "the servo is a model XL330-M288 (1200), not the declared one");
  const Error mode = dynamixel_start_error(
      [](auto& servos) { servos.store(1, dynamixel_x::kOperatingMode, 1, 1); });
  EXPECT_EQ(mode.kind, ErrorKind::kData);
  EXPECT_EQ(mode.what, "the servo does not hold positions (mode 1)");
  const Error overload = dynamixel_start_error([](auto& servos) { servos.overload(1); });
  EXPECT_EQ(overload.kind, ErrorKind::kSystem);
  EXPECT_EQ(overload.what, "the servo reports a hardware error (overload)");
  EXPECT_NE(overload.advice.find("reboot"), std::string::npos);
  const Error outside =
      dynamixel_start_error([](auto& servos) { servos.set_measured(1, 4200.0, 0.0); });
  EXPECT_EQ(outside.kind, ErrorKind::kData);
  const Error limits = dynamixel_start_error(
      [](auto& servos) { servos.store(1, dynamixel_x::kMinPosition, 4, 5000); });
  EXPECT_EQ(limits.kind, ErrorKind::kData);
}

TEST(DynamixelBus, DeclarationsThatCannotBeAreRefused) {
  EXPECT_THROW(DynamixelBus({}), InvalidArgument);
  EXPECT_THROW(DynamixelBus({{253, ""}}), InvalidArgument);
  EXPECT_THROW(DynamixelBus({{1, ""}, {1, ""}}), InvalidArgument);
  EXPECT_THROW(DynamixelBus({{1, "AX-12"}}), InvalidArgument);
  EXPECT_NO_THROW(DynamixelBus({{0, ""}, {252, "XL330-M077"}}));
}

TEST(DynamixelBus, ATickHasTheGoalsAndTheVelocitiesToReachThem) {
  DynamixelHand hand(3);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  // 100 steps in 0.02 s are 5000 steps/s, or 319.8 units of 15.6331 steps/s; 2 s: 3.198 units.
  const auto tick = hand.bus.tick(std::vector<double>{1100.0, kLeft, 1199.6}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFD, 0,    0xFE, 25,   0,    0x83, 112, 0, 8,
                    0,    1,    0x40, 0x01, 0,    0,    0x4C, 0x04, 0,   0,  // 320 and 1100
                    3,    0x01, 0x00, 0,    0,    0xB0, 0x04, 0,    0};      // 1 and 1200
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 30), goals);
  const Bytes request{0xFF, 0xFF, 0xFD, 0, 0xFE, 10, 0, 0x82, 126, 0, 10, 0, 1, 2, 3};
  EXPECT_EQ(Bytes(bytes.begin() + 32, bytes.end() - 2), request);
  const auto slow = hand.bus.tick(std::vector<double>{1000.0, kLeft, kLeft}, 2.0);
  EXPECT_EQ(slow[13], 4);
  const auto none = hand.bus.tick(std::vector<double>(3, kLeft), 0.02);
  EXPECT_EQ(Bytes(none.begin(), none.end() - 2), request);
}

TEST(DynamixelBus, GoalsStayWithinTheLimitsOfTheServo) {
  DynamixelHand hand(2);
  hand.servos.store(0, dynamixel_x::kMaxPosition, 4, 1050);
  hand.servos.store(1, dynamixel_x::kOperatingMode, 1, 5);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.tick({9000.0, -5000.0}, 10.0);
  EXPECT_EQ(static_cast<int>(hand.servos.stored(0, dynamixel_x::kGoalPosition, 4)), 1050);
  EXPECT_EQ(static_cast<int>(hand.servos.stored(1, dynamixel_x::kGoalPosition, 4)), -5000);
  hand.tick({std::numeric_limits<double>::infinity(), kLeft});
  EXPECT_EQ(static_cast<int>(hand.servos.stored(0, dynamixel_x::kGoalPosition, 4)), 1050);
}

TEST(DynamixelBus, StreamedGoalsMoveAServoEvenly) {
  for (const bool timed : {false, true}) {
    DynamixelHand hand(1);
    if (timed) hand.servos.store(0, dynamixel_x::kDriveMode, 1, dynamixel_x::kTimeBasedProfile);
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    double before = 1000.0;
    double largest = 0.0;
    for (int i = 1; i <= 100; ++i) {
      const double goal = 1000.0 + 10.0 * i;  // 500 steps/s, or 5 steps in each 10 ms
      ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>{goal}, 0.02)));
      for (int half = 0; half < 2; ++half) {
        hand.exchange.pause(0.01);
        const double at = *hand.servos.driven_position(0);
        largest = std::max(largest, std::abs(at - before - 5.0));
        before = at;
        hand.take();
      }
      EXPECT_NEAR(before, goal, 1e-9);
    }
    EXPECT_LT(largest, 0.2);  // of 5; without a profile it would be 5
  }
}

TEST(DynamixelBus, ReportsAreWhatTheServosMeasure) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.servos.set_measured(0, 1234.0, -250.0);
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[0].position, 1234.0);
  EXPECT_EQ(hand.bus.reports()[0].current, -250.0);
  EXPECT_EQ(hand.bus.reports()[0].time, hand.line.now());
}

TEST(DynamixelBus, AServoWithoutCurrentReportsNone) {
  DynamixelServos servos({{.id = 7, .model = 1060}});
  testing::BoardLine line(servos);
  wire::Exchange exchange(line, 0);
  DynamixelBus bus({{7, ""}});
  ASSERT_TRUE(bus.start(exchange));
  EXPECT_TRUE(std::isnan(bus.reports()[0].current));
  EXPECT_EQ(bus.reports()[0].position, 2048.0);
}

TEST(DynamixelBus, AnOverloadIsReportedAndARebootEndsIt) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.servos.overload(1);
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[0].error, 0);
  EXPECT_EQ(hand.bus.reports()[1].error, DynamixelBus::kUnknownError);
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[1].error, dynamixel_x::kOverload);
  const double time = hand.bus.reports()[1].time;
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[1].error, dynamixel_x::kOverload);
  EXPECT_GT(hand.bus.reports()[1].time, time);
  hand.servos.set_measured(1, 1500.0, 0.0);
  const auto rebooted = hand.bus.reboot(1, hand.exchange);
  ASSERT_TRUE(rebooted) << to_string(rebooted.error());
  EXPECT_EQ(hand.bus.reports()[1].error, 0);
  EXPECT_EQ(hand.servos.driven_position(1), 1500.0);
  EXPECT_EQ(hand.servos.driven_position(0), 1000.0);
}

TEST(DynamixelBus, AServoThatAnswersNothingKeepsItsOldReport) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.tick({kLeft, kLeft});
  const double time = hand.bus.reports()[0].time;
  hand.servos.set_silent(0, true);
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[0].time, time);
  EXPECT_GT(hand.bus.reports()[1].time, time);
  EXPECT_FALSE(hand.bus.reboot(0, hand.exchange));
}

TEST(DynamixelBus, AnErrorThatCannotBeReadDoesNotHideTheStates) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.servos.overload(1);
  hand.tick({kLeft, kLeft});
  hand.servos.set_silent(1, true);
  hand.tick({kLeft, kLeft});  // asks for errors
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus.reports()[0].time, hand.line.now());
}

// The packet that a simple servo reads last: it trusts each length that its memory can hold, and
// drops a packet with a wrong CRC whole.
Bytes last_packet_of_simple_servo(const Bytes& bytes) {
  Bytes last;
  for (std::size_t at = 0; at + 7 <= bytes.size();) {
    const Bytes header(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4);
    const bool possible = header == Bytes{0xFF, 0xFF, 0xFD, 0} && bytes[at + 6] == 0;
    const std::size_t size = possible ? 7u + bytes[at + 5] : 1u;
    if (at + size > bytes.size()) break;
    const Bytes packet(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    if (size > 1 && wire::dynamixel_crc(std::span(packet).first(size - 2)) ==
                        packet[size - 2] + 256 * packet[size - 1]) {
      last = packet;
    }
    at += size;
  }
  return last;
}

TEST(DynamixelBus, RelaxingWorksAfterAnyPartOfATick) {
  for (std::size_t cut = 0;; ++cut) {
    DynamixelHand hand(3);
    const Bytes relax(hand.bus.relax_bytes().begin(), hand.bus.relax_bytes().end());
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    const auto tick = hand.bus.tick(std::vector<double>{1.0, 2.0, 3.0}, 0.02);
    if (cut > tick.size()) break;
    Bytes bytes(tick.begin(), tick.begin() + static_cast<std::ptrdiff_t>(cut));
    bytes.insert(bytes.end(), relax.begin(), relax.end());
    ASSERT_TRUE(hand.exchange.send(bytes));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(hand.servos.driven_position(i)) << cut;
    const Bytes last = last_packet_of_simple_servo(bytes);
    ASSERT_EQ(last.size(), 13u) << cut;
    EXPECT_EQ(Bytes(last.begin(), last.end() - 2),
              (Bytes{0xFF, 0xFF, 0xFD, 0, 0xFE, 6, 0, 3, 64, 0, 0}));
    EXPECT_EQ(Bytes(hand.bus.relax_bytes().begin(), hand.bus.relax_bytes().end()), relax);
  }
}

TEST(DynamixelBus, TemperaturesAreReadFiveTimesInASecond) {
  DynamixelHand hand(2);
  hand.servos.heat(1, 71);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  EXPECT_TRUE(std::isnan(hand.bus.reports()[1].temperature));
  for (int i = 0; i < 20; ++i) {
    const auto tick = hand.bus.tick(std::vector<double>(2, kLeft), 0.02);
    ASSERT_TRUE(hand.exchange.send(tick));
    hand.exchange.pause(0.02);
    hand.take();
    EXPECT_NEAR(hand.bus.reports()[1].time, hand.line.now(), 0.02) << "its state comes as well";
  }
  EXPECT_EQ(hand.bus.reports()[0].temperature, 0.0);
  EXPECT_EQ(hand.bus.reports()[1].temperature, 71.0);
}

TEST(DynamixelBus, BytesOfATickAreBounded) {
  DynamixelHand hand(16);
  for (std::size_t i = 0; i < 16; ++i) {
    hand.servos.store(i, dynamixel_x::kOperatingMode, 1, 5);
    // From the current to the temperature, all bytes look like headers.
    hand.servos.set_measured(i, -131073.0, -1.0);
    hand.servos.store(i, 128, 4, 0xFDFFFFFD);
    hand.servos.store(i, 136, 4, 0xFFFFFDFF);
    hand.servos.store(i, 140, 4, 0xFDFFFFFD);
    hand.servos.store(i, 144, 2, 0xFFFF);
    hand.servos.heat(i, 0xFD);
  }
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  const std::size_t before = hand.line.sent.size();
  const auto tick = hand.bus.tick(std::vector<double>(16, -131073.0), 0.2);
  const std::size_t size = tick.size();
  ASSERT_TRUE(hand.exchange.send(tick));
  hand.exchange.pause(0.02);
  hand.take();
  EXPECT_EQ(hand.bus.reports()[15].position, -131073.0);
  const std::size_t both = size + hand.line.sent.size() - before;
  EXPECT_LE(both, hand.bus.bytes_per_tick());
  EXPECT_GE(both, hand.bus.bytes_per_tick() - 20);
}

TEST(DynamixelBus, DamagedAnswersNeverGiveAWrongReport) {
  Random random(3);
  DynamixelHand hand(4, true);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  std::size_t missing = 0;
  for (int i = 0; i < 3000; ++i) {
    const double place = 1000.0 + i % 500;
    for (std::size_t k = 0; k < 4; ++k) {
      hand.servos.set_measured(k, place + 600.0 * static_cast<double>(k), 7.0);
    }
    const auto tick = hand.bus.tick(std::vector<double>(4, kLeft), 0.02);
    ASSERT_TRUE(hand.exchange.send(tick));
    hand.exchange.pause(0.02);
    Bytes bytes(4096);
    bytes.resize(*hand.line.read(0, bytes));
    const auto damaged = testing::damaged_stream({bytes}, 0.002, 0, random);
    hand.bus.receive(damaged.bytes, hand.line.now());
    for (std::size_t k = 0; k < 4; ++k) {
      const ServoReport& report = hand.bus.reports()[k];
      if (report.time != hand.line.now()) {
        ++missing;
      } else {
        ASSERT_EQ(report.position, place + 600.0 * static_cast<double>(k));
        ASSERT_EQ(report.current, 7.0);
        ASSERT_EQ(report.error, 0);
      }
    }
  }
  RecordProperty("missing", static_cast<int>(missing));
  EXPECT_GT(missing, 300u);
  EXPECT_LT(missing, 1200u);
}

TEST(DynamixelBus, NoiseIsNoReport) {
  Random random(6);
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  const double before = hand.line.now();
  for (int i = 0; i < 20'000; ++i) {
    Bytes noise;
    testing::append_noise(noise, random);
    hand.bus.receive(noise, before + 1.0);
  }
  for (const ServoReport& report : hand.bus.reports()) EXPECT_LE(report.time, before);
  hand.tick({kLeft, kLeft});
  EXPECT_GT(hand.bus.reports()[1].time, before);
}

TEST(DynamixelBus, ATickAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP();
  DynamixelHand hand(16);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  const std::vector<double> positions(16, 1500.0);
  hand.servos.overload(3);
  for (int i = 0; i < 5; ++i) {
    const testing::AllocationCounter ticking;
    const auto tick = hand.bus.tick(positions, 0.02);
    EXPECT_EQ(ticking.count(), 0u);
    ASSERT_TRUE(hand.exchange.send(tick));
    hand.exchange.pause(0.02);
    Bytes bytes(4096);
    bytes.resize(*hand.line.read(0, bytes));
    ASSERT_GT(bytes.size(), 16u * 11);
    const testing::AllocationCounter receiving;
    hand.bus.receive(bytes, hand.line.now());
    EXPECT_EQ(receiving.count(), 0u);
  }
  EXPECT_THROW(hand.bus.tick(std::vector<double>(3), 0.02), InvalidArgument);
}

}  // namespace
}  // namespace somato::devices
