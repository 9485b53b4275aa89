#include "hardware/device_files/bus_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hardware/support/every_bus.h"
#include "hardware/support/packet_hand.h"

namespace somato::devices {
namespace {

using testing::PacketHand;

class BusScanTest : public ::testing::TestWithParam<BusKind> {};

// The servos that were found, as "1:777:STS3215 ".
std::string found_at(PacketHand& hand) {
  const auto found = scan_bus(hand.kind, hand.exchange, [] { return true; });
  if (!found) return to_string(found.error());
  std::string text;
  for (const FoundServo& servo : *found) {
    text += std::to_string(servo.id) + ":" + (servo.model ? std::to_string(*servo.model) : "?") +
            ":" + servo.name + " ";
  }
  return text;
}

std::string expected_servo(BusKind kind, const char* id) {
  switch (kind) {
    case BusKind::kDynamixel:
      return std::string(id) + ":1240:XC330-M288 ";
    case BusKind::kSts:
      return std::string(id) + ":777:STS3215 ";
    default:
      return std::string(id) + ":1284:SCS0009 ";
  }
}

TEST_P(BusScanTest, ListsTheServosThatAnswer) {
  for (const bool echo : {false, true}) {
    PacketHand hand(GetParam(), 3, echo);
    hand.servos->set_silent(1, true);
    EXPECT_EQ(found_at(hand), expected_servo(GetParam(), "1") + expected_servo(GetParam(), "3"))
        << echo;
  }
}

TEST_P(BusScanTest, WritesNothingToAServo) {
  PacketHand hand(GetParam(), 2);
  static_cast<void>(found_at(hand));
  for (std::size_t i = 0; i < 2; ++i) EXPECT_FALSE(hand.servos->driven_position(i));
  EXPECT_EQ(hand.servos->eeprom_writes(), 0U);
  // Every request is a ping or a read: their codes are the fifth byte of a Feetech packet, and the
  // eighth of a Dynamixel packet.
  const bool is_dynamixel = GetParam() == BusKind::kDynamixel;
  const std::size_t size = is_dynamixel ? 10 : 8;
  const std::size_t code = is_dynamixel ? 7 : 4;
  ASSERT_EQ(hand.line.written.size(), size * (is_dynamixel ? 253U : 254U));
  for (std::size_t i = 0; i < hand.line.written.size(); i += size) {
    ASSERT_EQ(hand.line.written[i + code], is_dynamixel ? 1 : 2);
  }
}

TEST_P(BusScanTest, EndsWhenItIsInterrupted) {
  PacketHand hand(GetParam(), 1);
  int requests = 0;
  const auto found = scan_bus(GetParam(), hand.exchange, [&] { return ++requests < 5; });
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ErrorKind::kInterrupted);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BusScanTest,
                         ::testing::Values(BusKind::kDynamixel, BusKind::kSts, BusKind::kScs));

TEST(BusScan, KnowsThatAnSsc32HasNoIds) {
  PacketHand hand(BusKind::kSts, 1);
  EXPECT_EQ(scan_bus(BusKind::kSsc32, hand.exchange, [] { return true; }).error().kind,
            ErrorKind::kUsage);
}

TEST(BusScan, TriesTheUsualSpeedOfEveryKind) {
  for (const BusKind kind : testing::every_bus()) {
    const BusTraits& bus = traits_of(kind);
    EXPECT_NE(std::ranges::find(bus.rates, bus.baud), bus.rates.end()) << bus.name;
    EXPECT_NE(bus.inquiry == nullptr, bus.no_scan == nullptr) << bus.name;
  }
}

}  // namespace
}  // namespace somato::devices
