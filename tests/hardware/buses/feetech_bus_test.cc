#include "hardware/buses/feetech_bus.h"

#include <gtest/gtest.h>

#include <vector>

#include "hardware/support/packet_hand.h"
#include "somato/core/check.h"

namespace somato::devices {
namespace {

using testing::Bytes;
using testing::kLeft;
using testing::PacketHand;
namespace feetech = wire::feetech;

// The laws of all buses are in packet_bus_test.cc.
constexpr std::array kBothSeries{BusKind::kSts, BusKind::kScs};

TEST(FeetechBus, StartNamesTheServoThatCannotBeUsed) {
  const Error mode = testing::start_error(
      BusKind::kSts, [](auto& servos) { servos.store(1, feetech::kMode, 1, 1); });
  EXPECT_EQ(mode.what, "the servo does not hold positions (mode 1)");
  const Error motor = testing::start_error(
      BusKind::kScs, [](auto& servos) { servos.store(1, feetech::kMaxPosition, 2, 0); });
  EXPECT_EQ(motor.kind, ErrorKind::kData);
}

TEST(FeetechBus, DeclarationsThatCannotBeAreRefused) {
  EXPECT_THROW(FeetechBus({}), InvalidArgument);
  EXPECT_THROW(FeetechBus({{254, "STS"}}), InvalidArgument);
  EXPECT_THROW(FeetechBus({{1, "STS"}, {1, "STS"}}), InvalidArgument);
  EXPECT_THROW(FeetechBus({{1, "STS"}, {2, "SCS"}}), InvalidArgument);
  EXPECT_THROW(FeetechBus({{1, ""}}), InvalidArgument);
  EXPECT_NO_THROW(FeetechBus({{0, "STS"}, {253, "STS3215"}}));
}

TEST(FeetechBus, AnStsTickHasGoalsWithSpeeds) {
  PacketHand hand(BusKind::kSts, 3);
  ASSERT_TRUE(hand.start());
  // 33 steps in 0.02 s are 1650 steps/s; 1 step in 0.02 s is 50; 301 in 2 s are 150.5, up to 200.
  const auto tick = hand.bus->tick(std::vector<double>{333.0, kLeft, 321.4}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFE, 18, 0x83, 42,   6,  //
                    1,    0x4D, 1,    0,  0,    0x72, 6, 3, 0x41, 1, 0, 0, 0x32, 0};
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 21), goals);
  EXPECT_EQ(Bytes(bytes.begin() + 22, bytes.end() - 1),
            (Bytes{0xFF, 0xFF, 0xFE, 7, 0x82, 56, 15, 1, 2, 3}));
  const auto slow = hand.bus->tick(std::vector<double>{634.0, kLeft, kLeft}, 2.0);
  EXPECT_EQ(slow[12], 200);
  const auto none = hand.bus->tick(std::vector<double>(3, kLeft), 0.02);
  EXPECT_EQ(none.size(), 11u);
}

TEST(FeetechBus, AnScsTickHasGoalsWithTimesAndAsksOneServo) {
  PacketHand hand(BusKind::kScs, 2);
  ASSERT_TRUE(hand.start());
  const auto tick = hand.bus->tick(std::vector<double>{333.0, 9999.0}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFE, 18, 0x83, 42, 6,  //
                    1,    1,    0x4D, 0,  20,   0,  0, 2, 3, 0xFF, 0, 20, 0, 0};
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 21), goals);
  EXPECT_EQ(Bytes(bytes.begin() + 22, bytes.end() - 1), (Bytes{0xFF, 0xFF, 1, 4, 2, 56, 8}));
  EXPECT_TRUE(hand.bus->follow_up().empty());  // it has not answered yet
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(hand.bus->tick(std::vector<double>(2, kLeft), 0.02).empty());
  }
  const auto next = hand.bus->tick(std::vector<double>(2, kLeft), 0.02);  // after 60 ms
  ASSERT_FALSE(next.empty());
  EXPECT_EQ(next[2], 2);
}

TEST(FeetechBus, ServosWithManyTurnsHaveNegativePositions) {
  PacketHand hand(BusKind::kSts, 1);
  hand.servos->store(0, feetech::kMaxPosition, 2, 0);
  hand.servos->set_measured(0, -300.0, 0.0);
  ASSERT_TRUE(hand.start());
  EXPECT_EQ(hand.bus->reports()[0].position, -300.0);
  EXPECT_EQ(hand.servos->driven_position(0), -300.0);
  hand.tick({-5000.0}, 1.0);
  EXPECT_NEAR(*hand.servos->driven_position(0), -5000.0, 1e-9);
}

TEST(FeetechBus, StartSetsNoAcceleration) {
  PacketHand hand(BusKind::kSts, 1);
  hand.servos->store(0, feetech::kAcceleration, 1, 50);
  ASSERT_TRUE(hand.start());
  EXPECT_EQ(hand.servos->stored(0, feetech::kAcceleration, 1), 0);
}

// The sum does not notice a missing byte 255 that the next packet completes.
TEST(FeetechBus, AnAnswerWithoutAByteIsNotCompletedByTheNext) {
  PacketHand hand(BusKind::kScs, 1);
  hand.servos->set_measured(0, 255.0, 0.0);
  ASSERT_TRUE(hand.start());
  ASSERT_TRUE(hand.exchange.send(hand.bus->tick(std::vector<double>{kLeft}, 0.02)));
  hand.exchange.pause(0.01);
  Bytes bytes(64);
  bytes.resize(*hand.line.read(0, bytes));
  ASSERT_EQ(bytes[6], 0xFF);
  bytes.erase(bytes.begin() + 6);
  hand.bus->receive(bytes, hand.line.now());
  hand.servos->set_measured(0, 300.0, 0.0);
  const double polled = hand.line.now();
  for (int i = 0; i < 3; ++i) hand.tick({kLeft});
  EXPECT_GT(hand.bus->reports()[0].time, polled);
  EXPECT_EQ(hand.bus->reports()[0].position, 300.0);
}

TEST(FeetechBus, AnAnswerThatArrivesAfterTheNextTickIsTaken) {
  PacketHand hand(BusKind::kScs, 3);
  ASSERT_TRUE(hand.start());
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t servo = i % 3;
    const double place = 400.0 + static_cast<double>(i);
    hand.servos->set_measured(servo, place, 0.0);
    ASSERT_TRUE(hand.exchange.send(hand.bus->tick(std::vector<double>(3, 512.0), 0.02)));
    hand.exchange.pause(0.02);
    ASSERT_TRUE(hand.exchange.send(hand.bus->tick(std::vector<double>(3, 512.0), 0.02)));
    hand.exchange.pause(0.02);
    hand.take();
    EXPECT_EQ(hand.bus->reports()[servo].position, place) << i;
  }
}

TEST(FeetechBus, AnScsServoThatDoesNotAnswerDelaysTheOthersOnce) {
  PacketHand hand(BusKind::kScs, 3);
  ASSERT_TRUE(hand.start());
  hand.servos->set_silent(1, true);
  const double time = hand.bus->reports()[1].time;
  hand.tick(std::vector<double>(3, kLeft));  // polls 1 and 2
  const double middle = hand.line.now();
  for (int i = 0; i < 3; ++i) hand.tick(std::vector<double>(3, kLeft));  // then 3, 1 and 2
  EXPECT_GT(hand.bus->reports()[0].time, middle);
  EXPECT_GT(hand.bus->reports()[2].time, middle);
  EXPECT_EQ(hand.bus->reports()[1].time, time);
}

TEST(FeetechBus, BytesOfATickAreExact) {
  for (const BusKind series : kBothSeries) {
    PacketHand hand(series, 8);
    ASSERT_TRUE(hand.start());
    const std::size_t before = hand.line.sent.size() + hand.line.written.size();
    hand.tick(std::vector<double>(8, 512.0));
    EXPECT_EQ(hand.line.sent.size() + hand.line.written.size() - before,
              hand.bus->bytes_per_tick());
  }
}

}  // namespace
}  // namespace somato::devices
