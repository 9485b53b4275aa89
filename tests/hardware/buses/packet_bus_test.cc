#include "hardware/buses/packet_bus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/support/packet_hand.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::devices {
namespace {

using testing::Bytes;
using testing::kLeft;
using testing::PacketHand;
using testing::start_error;
namespace dynamixel_x = wire::dynamixel_x;
namespace feetech = wire::feetech;

const Bytes kDynamixelRelax{0xFF, 0xFF, 0xFD, 0, 0xFE, 6, 0, 3, 64, 0, 0};
const Bytes kFeetechRelax{0xFF, 0xFF, 0xFE, 4, 3, 40, 0};

class PacketBusTest : public ::testing::TestWithParam<BusKind> {
 protected:
  static BusKind kind() { return GetParam(); }

  const bool dynamixel = kind() == BusKind::kDynamixel;
  // A setting of 0 leaves most instructions unanswered.
  const std::uint16_t answers = dynamixel ? dynamixel_x::kStatusReturn : feetech::kResponseLevel;
  const std::uint16_t delay = dynamixel ? dynamixel_x::kReturnDelay : feetech::kReturnDelay;
  const std::uint16_t model = dynamixel ? dynamixel_x::kModelNumber : feetech::kModel;
  const std::uint16_t lowest = dynamixel ? dynamixel_x::kMinPosition : feetech::kMinPosition;
};

INSTANTIATE_TEST_SUITE_P(Buses, PacketBusTest,
                         ::testing::Values(BusKind::kDynamixel, BusKind::kSts, BusKind::kScs),
                         [](const auto& kind) { return traits_of(kind.param).name; });

// The buses whose ticks request the states of all servos at once.
class SyncReadBusTest : public PacketBusTest {};
INSTANTIATE_TEST_SUITE_P(Buses, SyncReadBusTest,
                         ::testing::Values(BusKind::kDynamixel, BusKind::kSts),
                         [](const auto& kind) { return traits_of(kind.param).name; });

TEST_P(PacketBusTest, StartHoldsEveryServoWhereItIs) {
  for (const bool echo : {false, true}) {
    for (const bool quiet : {false, true}) {
      PacketHand hand(kind(), 3, echo);
      if (quiet) hand.servos->store(1, answers, 1, 0);
      const auto started = hand.start();
      ASSERT_TRUE(started) << to_string(started.error());
      for (std::size_t i = 0; i < 3; ++i) {
        const double place = PacketHand::place(kind(), i);
        EXPECT_EQ(hand.servos->driven_position(i), place);
        EXPECT_EQ(hand.bus->reports()[i].position, place);
        EXPECT_EQ(hand.bus->reports()[i].error, 0);
        EXPECT_GT(hand.bus->reports()[i].time, 0.0);
      }
      EXPECT_EQ(hand.servos->eeprom_writes(), 0u);
      EXPECT_TRUE(hand.bus->warnings().empty());
      EXPECT_TRUE(hand.bus->reports_states());
    }
  }
}

TEST_P(PacketBusTest, StartWarnsOfAReturnDelay) {
  PacketHand hand(kind(), 2);
  hand.servos->store(1, delay, 1, 250);
  ASSERT_TRUE(hand.start());
  ASSERT_EQ(hand.bus->warnings().size(), 1u);
  EXPECT_NE(hand.bus->warnings()[0].find("id 2: it waits 500 us"), std::string::npos);
  EXPECT_EQ(hand.servos->eeprom_writes(), 0u);
}

TEST_P(PacketBusTest, StartNamesTheServoThatCannotBeUsed) {
  const Error silent = start_error(kind(), [](auto& servos) { servos.set_silent(1, true); });
  EXPECT_EQ(silent.kind, ErrorKind::kSystem);
  EXPECT_EQ(silent.where, "servo with id 2");
  const Error other = start_error(kind(), [&](auto& servos) { servos.store(1, model, 2, 5); });
  EXPECT_EQ(other.kind, ErrorKind::kData);
  const Error overload = start_error(kind(), [](auto& servos) { servos.overload(1); });
  EXPECT_EQ(overload.kind, ErrorKind::kSystem);
  EXPECT_EQ(overload.what, dynamixel ? "the servo reports a hardware error (overload)"
                                     : "the servo reports an error (overload)");
  EXPECT_NE(overload.advice.find("reboot"), std::string::npos);
  const Error outside = start_error(kind(), [&](auto& servos) {
    servos.store(1, lowest, dynamixel ? 4 : 2, dynamixel ? 2000 : 400);
  });
  EXPECT_EQ(outside.kind, ErrorKind::kData);
}

TEST_P(PacketBusTest, StreamedGoalsMoveAServoEvenly) {
  for (const bool timed : {false, dynamixel}) {
    PacketHand hand(kind(), 1);
    if (timed) hand.servos->store(0, dynamixel_x::kDriveMode, 1, dynamixel_x::kTimeBasedProfile);
    ASSERT_TRUE(hand.start());
    const double start = PacketHand::place(kind(), 0);
    double before = start;
    double largest = 0.0;
    for (int i = 1; i <= 100; ++i) {
      const double goal = start + 7.0 * i;  // 350 steps/s, or 3.5 steps in each 10 ms
      ASSERT_TRUE(hand.exchange.send(hand.bus->tick(std::vector<double>{goal}, 0.02)));
      for (int half = 0; half < 2; ++half) {
        hand.exchange.pause(0.01);
        const double at = *hand.servos->driven_position(0);
        largest = std::max(largest, std::abs(at - before - 3.5));
        before = at;
        hand.take();
      }
      EXPECT_NEAR(before, goal, 1e-9);
    }
    EXPECT_LT(largest, 0.1);  // of 3.5; without speed or time it would be 3.5
  }
}

// During the tick that has just ended. The answers of Dynamixel servos are taken at its first step.
void expect_reported_after(double before, const ServoReport& report, const PacketHand& hand) {
  EXPECT_GT(report.time, before);
  EXPECT_LE(report.time, hand.line.now());
  if (hand.kind == BusKind::kDynamixel) {
    EXPECT_NEAR(report.time, before + 0.001, 1e-9);
  }
}

TEST_P(PacketBusTest, EveryTickReportsWhatAllServosMeasure) {
  for (const bool echo : {false, true}) {
    PacketHand hand(kind(), 4, echo);
    ASSERT_TRUE(hand.start());
    for (std::size_t i = 0; i < 4; ++i) {
      hand.servos->set_measured(i, 500.0 + static_cast<double>(i), -130.0);
    }
    const double before = hand.line.now();
    hand.tick({301.0, 302.0, 303.0, 304.0});
    for (std::size_t i = 0; i < 4; ++i) {
      const ServoReport& report = hand.bus->reports()[i];
      EXPECT_EQ(report.position, 500.0 + static_cast<double>(i));
      expect_reported_after(before, report, hand);
      EXPECT_EQ(std::isnan(report.current), kind() == BusKind::kScs);
      EXPECT_TRUE(std::isnan(report.current) || report.current == -130.0);
    }
  }
}

TEST_P(PacketBusTest, AnOverloadIsReportedAndARebootEndsIt) {
  for (const bool echo : {false, true}) {
    PacketHand hand(kind(), 2, echo);
    ASSERT_TRUE(hand.start());
    hand.servos->overload(1);
    hand.tick({kLeft, kLeft});
    EXPECT_EQ(hand.bus->reports()[0].error, 0);
    if (dynamixel) {  // its answer says only that there is an error
      EXPECT_EQ(hand.bus->reports()[1].error, DynamixelBus::kUnknownError);
      hand.tick({kLeft, kLeft});
    }
    EXPECT_EQ(hand.bus->reports()[1].error, feetech::kOverload);
    hand.servos->set_measured(1, 400.0, 0.0);
    const auto rebooted = hand.bus->reboot(1, hand.exchange);
    ASSERT_TRUE(rebooted) << to_string(rebooted.error());
    EXPECT_EQ(hand.bus->reports()[1].error, 0);
    EXPECT_EQ(hand.servos->driven_position(1), 400.0);
    EXPECT_EQ(hand.servos->driven_position(0), PacketHand::place(kind(), 0));
  }
}

TEST_P(PacketBusTest, AServoThatAnswersNothingKeepsItsOldReport) {
  PacketHand hand(kind(), 2);
  ASSERT_TRUE(hand.start());
  hand.tick({kLeft, kLeft});
  const double time = hand.bus->reports()[1].time;
  const double before = hand.line.now();
  hand.servos->set_silent(1, true);
  hand.tick({kLeft, kLeft});
  EXPECT_EQ(hand.bus->reports()[1].time, time);
  expect_reported_after(before, hand.bus->reports()[0], hand);
  EXPECT_FALSE(hand.bus->reboot(1, hand.exchange));
}

// The packet that a simple servo reads last: it trusts each length that its memory can hold, and
// drops a packet with a wrong check whole.
Bytes last_packet_of_simple_servo(bool dynamixel, const Bytes& bytes) {
  const std::size_t head = dynamixel ? 7 : 4;  // as far as the length
  Bytes last;
  for (std::size_t at = 0; at + head <= bytes.size();) {
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const bool starts =
        dynamixel ? std::equal(first, first + 4, kDynamixelRelax.begin()) && bytes[at + 6] == 0
                  : first[0] == 0xFF && first[1] == 0xFF && first[2] != 0xFF && bytes[at + 3] >= 2;
    const std::size_t size = starts ? head + bytes[at + (dynamixel ? 5 : 3)] : 1;
    if (at + size > bytes.size()) break;
    const Bytes packet(first, first + static_cast<std::ptrdiff_t>(size));
    unsigned sum = 0;
    for (std::size_t i = 2; i < size; ++i) sum += packet[i];
    const bool whole =
        starts && (dynamixel ? wire::dynamixel_crc(std::span(packet).first(size - 2)) ==
                                   packet[size - 2] + 256 * packet[size - 1]
                             : sum % 256 == 255);
    if (whole) last = packet;
    at += size;
  }
  return last;
}

TEST_P(PacketBusTest, RelaxingWorksAfterAnyPartOfATick) {
  for (std::size_t cut = 0;; ++cut) {
    PacketHand hand(kind(), 3);
    const Bytes relax(hand.bus->relax_bytes().begin(), hand.bus->relax_bytes().end());
    ASSERT_TRUE(hand.start());
    const auto tick = hand.bus->tick(std::vector<double>{1.0, 2.0, 3.0}, 0.02);
    if (cut > tick.size()) break;
    Bytes bytes(tick.begin(), tick.begin() + static_cast<std::ptrdiff_t>(cut));
    bytes.insert(bytes.end(), relax.begin(), relax.end());
    ASSERT_TRUE(hand.exchange.send(bytes));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(hand.servos->driven_position(i)) << cut;
    Bytes last = last_packet_of_simple_servo(dynamixel, bytes);
    const Bytes& whole = dynamixel ? kDynamixelRelax : kFeetechRelax;
    ASSERT_EQ(last.size(), whole.size() + (dynamixel ? 2 : 1)) << cut;
    last.resize(whole.size());
    EXPECT_EQ(last, whole) << cut;
    EXPECT_EQ(Bytes(hand.bus->relax_bytes().begin(), hand.bus->relax_bytes().end()), relax);
  }
}

// The CRC of Dynamixel servos protects their reports, the sum of Feetech servos nearly all.
TEST_P(SyncReadBusTest, DamagedAnswersRarelyGiveAWrongReport) {
  Random random(4);
  PacketHand hand(kind(), 6, true);
  ASSERT_TRUE(hand.start());
  std::size_t missing = 0;
  std::size_t wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto place = [&](std::size_t k) { return (i * 37 + 600 * static_cast<int>(k)) % 4096; };
    for (std::size_t k = 0; k < 6; ++k) {
      hand.servos->set_measured(k, place(k), 65.0);
      if (kind() == BusKind::kSts) hand.servos->store(k, 67, 2, 1000);  // the goal's copy
    }
    ASSERT_TRUE(hand.exchange.send(hand.bus->tick(std::vector<double>(6, kLeft), 0.02)));
    hand.exchange.pause(0.02);
    const auto damaged = testing::damaged_stream({hand.arrived()}, 0.001, 0, random);
    hand.bus->receive(damaged.bytes, hand.line.now());
    for (std::size_t k = 0; k < 6; ++k) {
      const ServoReport& report = hand.bus->reports()[k];
      if (report.time != hand.line.now()) {
        ++missing;
      } else if (report.position != place(k) || report.current != 65.0 || report.error != 0) {
        ++wrong;
      }
    }
  }
  RecordProperty("missing", static_cast<int>(missing));
  RecordProperty("wrong", static_cast<int>(wrong));
  EXPECT_GT(missing, 500u);
  EXPECT_LT(missing, 1500u);
  EXPECT_LE(wrong, kind() == BusKind::kSts ? 2u : 0u);
}

TEST_P(PacketBusTest, NoiseIsNoReport) {
  Random random(6);
  PacketHand hand(kind(), 2);
  ASSERT_TRUE(hand.start());
  const double before = hand.line.now();
  for (int i = 0; i < 20'000; ++i) {
    Bytes noise;
    testing::append_noise(noise, random);
    hand.bus->receive(noise, before + 1.0);
  }
  for (const ServoReport& report : hand.bus->reports()) EXPECT_LE(report.time, before);
  hand.tick({kLeft, kLeft});
  expect_reported_after(before, hand.bus->reports()[1], hand);
}

// Also while the error of a servo is not known yet.
TEST_P(PacketBusTest, ATickAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP();
  for (const bool overloaded : {false, true}) {
    PacketHand hand(kind(), 16);
    ASSERT_TRUE(hand.start());
    if (overloaded) hand.servos->overload(3);
    const std::vector<double> positions(16, 512.0);
    for (int i = 0; i < 5; ++i) {
      const testing::AllocationCounter ticking;
      const auto tick = hand.bus->tick(positions, 0.02);
      EXPECT_EQ(ticking.count(), 0u);
      ASSERT_TRUE(hand.exchange.send(tick));
      hand.exchange.pause(0.02);
      const Bytes arrived = hand.arrived();
      ASSERT_GE(arrived.size(), kind() == BusKind::kScs ? 12u : 16u * 11 + 1);
      const testing::AllocationCounter receiving;
      hand.bus->receive(arrived, hand.line.now());
      const auto next = hand.bus->follow_up();
      EXPECT_EQ(receiving.count(), 0u);
      EXPECT_EQ(next.empty(), kind() != BusKind::kScs);
      ASSERT_TRUE(hand.exchange.send(next));
    }
    EXPECT_THROW(hand.bus->tick(std::vector<double>(3), 0.02), InvalidArgument);
  }
}

}  // namespace
}  // namespace somato::devices
