#include "hardware/buses/dynamixel_bus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hardware/support/packet_hand.h"
#include "somato/core/check.h"

namespace somato::devices {
namespace {

using emulation::DynamixelServos;
using testing::Bytes;
using testing::kLeft;
using testing::PacketHand;
namespace dynamixel_x = wire::dynamixel_x;

// The laws of all buses are in packet_bus_test.cc.
struct DynamixelHand : PacketHand {
  explicit DynamixelHand(std::size_t count, bool echo = false)
      : PacketHand(BusKind::kDynamixel, count, echo) {}
};

TEST(DynamixelBus, StartSetsServosToAnswer) {
  DynamixelHand hand(2, true);
  hand.servos->store(0, dynamixel_x::kStatusReturn, 1, 0);
  ASSERT_TRUE(hand.start());
  EXPECT_EQ(hand.servos->stored(0, dynamixel_x::kStatusReturn, 1), 2u);
}

TEST(DynamixelBus, StartIsNotMisledByALateAnswerOfAnotherServo) {
  DynamixelHand hand(2);
  hand.servos->store(1, dynamixel_x::kReturnDelay, 1, 250);
  Bytes memory(32);
  wire::DynamixelWriter writer(memory);
  writer.read(2, dynamixel_x::kPresentPosition, 3);  // as long as the answer to a ping
  ASSERT_TRUE(hand.exchange.send(writer.written()));
  const auto started = hand.start();
  EXPECT_TRUE(started) << to_string(started.error());
}

TEST(DynamixelBus, StartWarnsOfSettingsThatItDoesNotChange) {
  DynamixelHand hand(2);
  hand.servos->store(1, dynamixel_x::kReturnDelay, 1, 250);
  hand.servos->store(1, dynamixel_x::kDriveMode, 1, dynamixel_x::kTorqueOnByGoal);
  ASSERT_TRUE(hand.start());
  EXPECT_EQ(hand.bus->warnings().size(), 2u);
  EXPECT_EQ(hand.servos->eeprom_writes(), 0u);
}

TEST(DynamixelBus, StartNamesTheServoThatCannotBeUsed) {
  const auto error_after = [](const auto& change) {
    return testing::start_error(BusKind::kDynamixel, change);
  };
  const Error model =
      error_after([](auto& servos) { servos.store(1, dynamixel_x::kModelNumber, 2, 1200); });
  EXPECT_EQ(model.kind, ErrorKind::kData);
  EXPECT_EQ(model.what, "the servo is a model XL330-M288 (1200), not the declared one");
  const Error mode =
      error_after([](auto& servos) { servos.store(1, dynamixel_x::kOperatingMode, 1, 1); });
  EXPECT_EQ(mode.kind, ErrorKind::kData);
  EXPECT_EQ(mode.what, "the servo does not hold positions (mode 1)");
  const Error outside = error_after([](auto& servos) { servos.set_measured(1, 4200.0, 0.0); });
  EXPECT_EQ(outside.kind, ErrorKind::kData);
  const Error limits =
      error_after([](auto& servos) { servos.store(1, dynamixel_x::kMinPosition, 4, 5000); });
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
  ASSERT_TRUE(hand.start());
  // 100 steps in 0.02 s are 5000 steps/s, or 319.8 units of 15.6331 steps/s; 2 s: 3.198 units.
  const auto tick = hand.bus->tick(std::vector<double>{1100.0, kLeft, 1199.6}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFD, 0,    0xFE, 25,   0,    0x83, 112, 0, 8,
                    0,    1,    0x40, 0x01, 0,    0,    0x4C, 0x04, 0,   0,  // 320 and 1100
                    3,    0x01, 0x00, 0,    0,    0xB0, 0x04, 0,    0};      // 1 and 1200
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 30), goals);
  const Bytes request{0xFF, 0xFF, 0xFD, 0, 0xFE, 10, 0, 0x82, 126, 0, 10, 0, 1, 2, 3};
  EXPECT_EQ(Bytes(bytes.begin() + 32, bytes.end() - 2), request);
  const auto slow = hand.bus->tick(std::vector<double>{1000.0, kLeft, kLeft}, 2.0);
  EXPECT_EQ(slow[13], 4);
  const auto none = hand.bus->tick(std::vector<double>(3, kLeft), 0.02);
  EXPECT_EQ(Bytes(none.begin(), none.end() - 2), request);
}

TEST(DynamixelBus, GoalsStayWithinTheLimitsOfTheServo) {
  DynamixelHand hand(2);
  hand.servos->store(0, dynamixel_x::kMaxPosition, 4, 1050);
  hand.servos->store(1, dynamixel_x::kOperatingMode, 1, 5);
  ASSERT_TRUE(hand.start());
  hand.tick({9000.0, -5000.0}, 10.0);
  EXPECT_EQ(static_cast<int>(hand.servos->stored(0, dynamixel_x::kGoalPosition, 4)), 1050);
  EXPECT_EQ(static_cast<int>(hand.servos->stored(1, dynamixel_x::kGoalPosition, 4)), -5000);
  hand.tick({std::numeric_limits<double>::infinity(), kLeft});
  EXPECT_EQ(static_cast<int>(hand.servos->stored(0, dynamixel_x::kGoalPosition, 4)), 1050);
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

TEST(DynamixelBus, AnOverloadStaysReported) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.start());
  hand.servos->overload(1);
  for (int i = 0; i < 2; ++i) hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus->reports()[1].error, dynamixel_x::kOverload);
  const double time = hand.bus->reports()[1].time;
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus->reports()[1].error, dynamixel_x::kOverload);
  EXPECT_GT(hand.bus->reports()[1].time, time);
}

TEST(DynamixelBus, AnErrorThatCannotBeReadDoesNotHideTheStates) {
  DynamixelHand hand(2);
  ASSERT_TRUE(hand.start());
  hand.servos->overload(1);
  hand.tick({kLeft, kLeft});
  hand.servos->set_silent(1, true);
  hand.tick({kLeft, kLeft});  // requests errors
  const double before = hand.line.now();
  hand.tick({kLeft, kLeft});
  EXPECT_GT(hand.bus->reports()[0].time, before);
}

TEST(DynamixelBus, TemperaturesAreReadFiveTimesInASecond) {
  DynamixelHand hand(2);
  hand.servos->heat(1, 71);
  ASSERT_TRUE(hand.start());
  EXPECT_TRUE(std::isnan(hand.bus->reports()[1].temperature));
  for (int i = 0; i < 20; ++i) {
    const auto tick = hand.bus->tick(std::vector<double>(2, kLeft), 0.02);
    ASSERT_TRUE(hand.exchange.send(tick));
    hand.exchange.pause(0.02);
    hand.take();
    EXPECT_NEAR(hand.bus->reports()[1].time, hand.line.now(), 0.02) << "its state comes as well";
  }
  EXPECT_EQ(hand.bus->reports()[0].temperature, 0.0);
  EXPECT_EQ(hand.bus->reports()[1].temperature, 71.0);
}

TEST(DynamixelBus, BytesOfATickAreBounded) {
  DynamixelHand hand(16);
  for (std::size_t i = 0; i < 16; ++i) {
    hand.servos->store(i, dynamixel_x::kOperatingMode, 1, 5);
    // From the current to the temperature, all bytes look like headers.
    hand.servos->set_measured(i, -131073.0, -1.0);
    hand.servos->store(i, 128, 4, 0xFDFFFFFD);
    hand.servos->store(i, 136, 4, 0xFFFFFDFF);
    hand.servos->store(i, 140, 4, 0xFDFFFFFD);
    hand.servos->store(i, 144, 2, 0xFFFF);
    hand.servos->heat(i, 0xFD);
  }
  ASSERT_TRUE(hand.start());
  const std::size_t before = hand.line.sent.size();
  const auto tick = hand.bus->tick(std::vector<double>(16, -131073.0), 0.2);
  const std::size_t size = tick.size();
  ASSERT_TRUE(hand.exchange.send(tick));
  hand.exchange.pause(0.02);
  hand.take();
  EXPECT_EQ(hand.bus->reports()[15].position, -131073.0);
  const std::size_t both = size + hand.line.sent.size() - before;
  EXPECT_LE(both, hand.bus->bytes_per_tick());
  EXPECT_GE(both, hand.bus->bytes_per_tick() - 20);
}

}  // namespace
}  // namespace somato::devices
