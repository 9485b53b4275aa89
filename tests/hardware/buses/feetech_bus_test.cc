#include "hardware/buses/feetech_bus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/emulation/feetech_servos.h"
#include "hardware/support/board_line.h"
#include "hardware/support/damaged_streams.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::devices {
namespace {

using emulation::FeetechServos;
using testing::Bytes;
using wire::FeetechSeries;
namespace feetech = wire::feetech;

constexpr double kAsItIs = std::numeric_limits<double>::quiet_NaN();

// A bus and its servos with the ids 1, 2, ... at one line, at positions 300, 310, ...
struct FeetechHand {
  FeetechHand(FeetechSeries series, std::size_t count, bool echo = false)
      : servos(series, made(series, count), echo),
        line(servos),
        exchange(line, 0),
        bus(declared(series, count)) {}

  static std::vector<emulation::EmulatedFeetech> made(FeetechSeries series, std::size_t count) {
    std::vector<emulation::EmulatedFeetech> all(count);
    const std::uint16_t model = series == FeetechSeries::kSts ? 777 : 1284;
    for (std::size_t i = 0; i < count; ++i) {
      all[i] = {.id = static_cast<std::uint8_t>(i + 1),
                .model = model,
                .position = 300.0 + 10.0 * static_cast<double>(i)};
    }
    return all;
  }

  static std::vector<PacketServo> declared(FeetechSeries series, std::size_t count) {
    std::vector<PacketServo> all;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back({static_cast<std::uint8_t>(i + 1),
                     series == FeetechSeries::kSts ? "STS3215" : "SCS0009"});
    }
    return all;
  }

  void take() {
    Bytes bytes(4096);
    const auto count = line.read(0, bytes);
    ASSERT_TRUE(count);
    bus.receive(std::span(bytes).first(*count), line.now());
  }

  // One tick with its follow-ups.
  void tick(const std::vector<double>& positions, double seconds = 0.02) {
    const double until = line.now() + seconds;
    auto bytes = bus.tick(positions, seconds);
    for (; !bytes.empty(); bytes = bus.follow_up()) {
      ASSERT_TRUE(exchange.send(bytes));
      exchange.pause(0.001);
      take();
    }
    exchange.pause(until - line.now());
  }

  FeetechServos servos;
  testing::BoardLine line;
  wire::Exchange exchange;
  FeetechBus bus;
};

constexpr std::array kBothSeries{FeetechSeries::kSts, FeetechSeries::kScs};

TEST(FeetechBus, StartHoldsEveryServoWhereItIs) {
  for (const FeetechSeries series : kBothSeries) {
    for (const bool echo : {false, true}) {
      FeetechHand hand(series, 3, echo);
      hand.servos.store(1, feetech::kResponseLevel, 1, 0);
      const auto started = hand.bus.start(hand.exchange);
      ASSERT_TRUE(started) << to_string(started.error());
      for (std::size_t i = 0; i < 3; ++i) {
        const double place = 300.0 + 10.0 * static_cast<double>(i);
        EXPECT_EQ(hand.servos.driven_position(i), place);
        EXPECT_EQ(hand.bus.reports()[i].position, place);
        EXPECT_EQ(hand.bus.reports()[i].error, 0);
      }
      EXPECT_EQ(hand.servos.eeprom_writes(), 0u);
      EXPECT_TRUE(hand.bus.warnings().empty());
    }
  }
}

TEST(FeetechBus, StartWarnsOfAReturnDelay) {
  FeetechHand hand(FeetechSeries::kSts, 1);
  hand.servos.store(0, feetech::kReturnDelay, 1, 250);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  ASSERT_EQ(hand.bus.warnings().size(), 1u);
  EXPECT_NE(hand.bus.warnings()[0].find("500 us"), std::string::npos);
  EXPECT_EQ(hand.servos.eeprom_writes(), 0u);
}

// Returns the error of start() after `change`, and checks that no servo holds.
template <typename Change>
Error feetech_start_error(FeetechSeries series, const Change& change) {
  FeetechHand hand(series, 2);
  change(hand.servos);
  const auto started = hand.bus.start(hand.exchange);
  EXPECT_FALSE(started);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_FALSE(hand.servos.driven_position(i));
  return started ? Error{} : started.error();
}

TEST(FeetechBus, StartNamesTheServoThatCannotBeUsed) {
  for (const FeetechSeries series : kBothSeries) {
    const Error silent =
        feetech_start_error(series, [](auto& servos) { servos.set_silent(1, true); });
    EXPECT_EQ(silent.kind, ErrorKind::kSystem);
    EXPECT_EQ(silent.where, "servo with id 2");
    const Error model =
        feetech_start_error(series, [](auto& servos) { servos.store(1, feetech::kModel, 2, 5); });
    EXPECT_EQ(model.kind, ErrorKind::kData);
    const Error overload = feetech_start_error(series, [](auto& servos) { servos.overload(1); });
    EXPECT_EQ(overload.kind, ErrorKind::kSystem);
    EXPECT_EQ(overload.what, "the servo reports an error (overload)");
    EXPECT_NE(overload.advice.find("reboot"), std::string::npos);
    const Error outside = feetech_start_error(
        series, [](auto& servos) { servos.store(1, feetech::kMinPosition, 2, 400); });
    EXPECT_EQ(outside.kind, ErrorKind::kData);
  }
  const Error mode = feetech_start_error(
      FeetechSeries::kSts, [](auto& servos) { servos.store(1, feetech::kMode, 1, 1); });
  EXPECT_EQ(mode.what, "the servo does not hold positions (mode 1)");
  const Error motor = feetech_start_error(
      FeetechSeries::kScs, [](auto& servos) { servos.store(1, feetech::kMaxPosition, 2, 0); });
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
  FeetechHand hand(FeetechSeries::kSts, 3);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  // 33 steps in 0.02 s are 1650 steps/s; 1 step in 0.02 s is 50; 301 in 2 s are 150.5, up to 200.
  const auto tick = hand.bus.tick(std::vector<double>{333.0, kAsItIs, 321.4}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFE, 18, 0x83, 42,   6,  //
                    1,    0x4D, 1,    0,  0,    0x72, 6, 3, 0x41, 1, 0, 0, 0x32, 0};
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 21), goals);
  EXPECT_EQ(Bytes(bytes.begin() + 22, bytes.end() - 1),
            (Bytes{0xFF, 0xFF, 0xFE, 7, 0x82, 56, 15, 1, 2, 3}));
  const auto slow = hand.bus.tick(std::vector<double>{634.0, kAsItIs, kAsItIs}, 2.0);
  EXPECT_EQ(slow[12], 200);
  const auto none = hand.bus.tick(std::vector<double>(3, kAsItIs), 0.02);
  EXPECT_EQ(none.size(), 11u);
}

TEST(FeetechBus, AnScsTickHasGoalsWithTimesAndAsksOneServo) {
  FeetechHand hand(FeetechSeries::kScs, 2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  const auto tick = hand.bus.tick(std::vector<double>{333.0, 9999.0}, 0.02);
  const Bytes bytes(tick.begin(), tick.end());
  const Bytes goals{0xFF, 0xFF, 0xFE, 18, 0x83, 42, 6,  //
                    1,    1,    0x4D, 0,  20,   0,  0, 2, 3, 0xFF, 0, 20, 0, 0};
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 21), goals);
  EXPECT_EQ(Bytes(bytes.begin() + 22, bytes.end() - 1), (Bytes{0xFF, 0xFF, 1, 4, 2, 56, 8}));
  EXPECT_TRUE(hand.bus.follow_up().empty());  // it has not answered yet
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(hand.bus.tick(std::vector<double>(2, kAsItIs), 0.02).empty());
  }
  const auto next = hand.bus.tick(std::vector<double>(2, kAsItIs), 0.02);  // after 60 ms
  ASSERT_FALSE(next.empty());
  EXPECT_EQ(next[2], 2);
}

TEST(FeetechBus, ServosWithManyTurnsHaveNegativePositions) {
  FeetechHand hand(FeetechSeries::kSts, 1);
  hand.servos.store(0, feetech::kMaxPosition, 2, 0);
  hand.servos.set_measured(0, -300.0, 0.0);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  EXPECT_EQ(hand.bus.reports()[0].position, -300.0);
  EXPECT_EQ(hand.servos.driven_position(0), -300.0);
  hand.tick({-5000.0}, 1.0);
  EXPECT_NEAR(*hand.servos.driven_position(0), -5000.0, 1e-9);
}

TEST(FeetechBus, StartSetsNoAcceleration) {
  FeetechHand hand(FeetechSeries::kSts, 1);
  hand.servos.store(0, feetech::kAcceleration, 1, 50);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  EXPECT_EQ(hand.servos.stored(0, feetech::kAcceleration, 1), 0);
}

// The sum does not notice a missing byte 255 that the next packet completes.
TEST(FeetechBus, AnAnswerWithoutAByteIsNotCompletedByTheNext) {
  FeetechHand hand(FeetechSeries::kScs, 1);
  hand.servos.set_measured(0, 255.0, 0.0);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>{kAsItIs}, 0.02)));
  hand.exchange.pause(0.01);
  Bytes bytes(64);
  bytes.resize(*hand.line.read(0, bytes));
  ASSERT_EQ(bytes[6], 0xFF);
  bytes.erase(bytes.begin() + 6);
  hand.bus.receive(bytes, hand.line.now());
  hand.servos.set_measured(0, 300.0, 0.0);
  const double polled = hand.line.now();
  for (int i = 0; i < 3; ++i) hand.tick({kAsItIs});
  EXPECT_GT(hand.bus.reports()[0].time, polled);
  EXPECT_EQ(hand.bus.reports()[0].position, 300.0);
}

TEST(FeetechBus, StreamedGoalsMoveAServoEvenly) {
  for (const FeetechSeries series : kBothSeries) {
    FeetechHand hand(series, 1);
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    double before = 300.0;
    double largest = 0.0;
    for (int i = 1; i <= 100; ++i) {
      const double goal = 300.0 + 7.0 * i;  // 350 steps/s, or 3.5 steps in each 10 ms
      ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>{goal}, 0.02)));
      for (int half = 0; half < 2; ++half) {
        hand.exchange.pause(0.01);
        const double at = *hand.servos.driven_position(0);
        largest = std::max(largest, std::abs(at - before - 3.5));
        before = at;
        hand.take();
      }
      EXPECT_NEAR(before, goal, 1e-9);
    }
    EXPECT_LT(largest, 0.1);  // of 3.5; without speed or time it would be 3.5
  }
}

TEST(FeetechBus, EveryTickReportsAllServos) {
  for (const FeetechSeries series : kBothSeries) {
    for (const bool echo : {false, true}) {
      FeetechHand hand(series, 4, echo);
      ASSERT_TRUE(hand.bus.start(hand.exchange));
      for (std::size_t i = 0; i < 4; ++i) {
        hand.servos.set_measured(i, 500.0 + static_cast<double>(i), -130.0);
      }
      const double before = hand.line.now();
      hand.tick({301.0, 302.0, 303.0, 304.0});
      for (std::size_t i = 0; i < 4; ++i) {
        const ServoReport& report = hand.bus.reports()[i];
        EXPECT_EQ(report.position, 500.0 + static_cast<double>(i));
        EXPECT_GT(report.time, before);
        EXPECT_EQ(std::isnan(report.current), series == FeetechSeries::kScs);
        EXPECT_TRUE(std::isnan(report.current) || report.current == -130.0);
      }
    }
  }
}

TEST(FeetechBus, AnAnswerThatArrivesAfterTheNextTickIsTaken) {
  FeetechHand hand(FeetechSeries::kScs, 3);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t servo = i % 3;
    const double place = 400.0 + static_cast<double>(i);
    hand.servos.set_measured(servo, place, 0.0);
    ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>(3, 512.0), 0.02)));
    hand.exchange.pause(0.02);
    ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>(3, 512.0), 0.02)));
    hand.exchange.pause(0.02);
    hand.take();
    EXPECT_EQ(hand.bus.reports()[servo].position, place) << i;
  }
}

TEST(FeetechBus, AnScsServoThatDoesNotAnswerDelaysTheOthersOnce) {
  FeetechHand hand(FeetechSeries::kScs, 3);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  hand.servos.set_silent(1, true);
  const double time = hand.bus.reports()[1].time;
  hand.tick(std::vector<double>(3, kAsItIs));  // polls 1 and 2
  const double middle = hand.line.now();
  for (int i = 0; i < 3; ++i) hand.tick(std::vector<double>(3, kAsItIs));  // then 3, 1 and 2
  EXPECT_GT(hand.bus.reports()[0].time, middle);
  EXPECT_GT(hand.bus.reports()[2].time, middle);
  EXPECT_EQ(hand.bus.reports()[1].time, time);
}

TEST(FeetechBus, AnOverloadIsReportedAndARebootEndsIt) {
  for (const FeetechSeries series : kBothSeries) {
    FeetechHand hand(series, 2, true);
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    hand.servos.overload(1);
    hand.tick({kAsItIs, kAsItIs});
    EXPECT_EQ(hand.bus.reports()[0].error, 0);
    EXPECT_EQ(hand.bus.reports()[1].error, feetech::kOverload);
    hand.servos.set_measured(1, 400.0, 0.0);
    const auto rebooted = hand.bus.reboot(1, hand.exchange);
    ASSERT_TRUE(rebooted) << to_string(rebooted.error());
    EXPECT_EQ(hand.bus.reports()[1].error, 0);
    EXPECT_EQ(hand.servos.driven_position(1), 400.0);
    EXPECT_EQ(hand.servos.driven_position(0), 300.0);
  }
}

// The packet that a simple servo reads last: it trusts each length, and drops a packet with a wrong
// sum whole.
Bytes last_packet_of_simple_feetech(const Bytes& bytes) {
  Bytes last;
  for (std::size_t at = 0; at + 4 <= bytes.size();) {
    const bool starts =
        bytes[at] == 0xFF && bytes[at + 1] == 0xFF && bytes[at + 2] != 0xFF && bytes[at + 3] >= 2;
    const std::size_t size = starts ? 4u + bytes[at + 3] : 1u;
    if (at + size > bytes.size()) break;
    unsigned sum = 0;
    for (std::size_t i = 2; i < size; ++i) sum += bytes[at + i];
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    if (starts && sum % 256 == 255) last = Bytes(first, first + static_cast<std::ptrdiff_t>(size));
    at += size;
  }
  return last;
}

TEST(FeetechBus, RelaxingWorksAfterAnyPartOfATick) {
  for (std::size_t cut = 0;; ++cut) {
    FeetechHand hand(FeetechSeries::kSts, 3);
    const Bytes relax(hand.bus.relax_bytes().begin(), hand.bus.relax_bytes().end());
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    const auto tick = hand.bus.tick(std::vector<double>{1.0, 2.0, 3.0}, 0.02);
    if (cut > tick.size()) break;
    Bytes bytes(tick.begin(), tick.begin() + static_cast<std::ptrdiff_t>(cut));
    bytes.insert(bytes.end(), relax.begin(), relax.end());
    ASSERT_TRUE(hand.exchange.send(bytes));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(hand.servos.driven_position(i)) << cut;
    EXPECT_EQ(last_packet_of_simple_feetech(bytes), (Bytes{0xFF, 0xFF, 0xFE, 4, 3, 40, 0, 0xD2}))
        << cut;
    EXPECT_EQ(Bytes(hand.bus.relax_bytes().begin(), hand.bus.relax_bytes().end()), relax);
  }
}

TEST(FeetechBus, BytesOfATickAreExact) {
  for (const FeetechSeries series : kBothSeries) {
    FeetechHand hand(series, 8);
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    const std::size_t before = hand.line.sent.size() + hand.line.written.size();
    hand.tick(std::vector<double>(8, 512.0));
    EXPECT_EQ(hand.line.sent.size() + hand.line.written.size() - before, hand.bus.bytes_per_tick());
  }
}

TEST(FeetechBus, DamagedAnswersOfStsServosRarelyGiveAWrongReport) {
  Random random(4);
  FeetechHand hand(FeetechSeries::kSts, 6, true);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  std::size_t missing = 0;
  std::size_t wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto place = [&](std::size_t k) { return (i * 37 + 600 * static_cast<int>(k)) % 4096; };
    for (std::size_t k = 0; k < 6; ++k) hand.servos.set_measured(k, place(k), 65.0);
    for (std::size_t k = 0; k < 6; ++k) hand.servos.store(k, 67, 2, 1000);  // the goal's copy
    ASSERT_TRUE(hand.exchange.send(hand.bus.tick(std::vector<double>(6, kAsItIs), 0.02)));
    hand.exchange.pause(0.02);
    Bytes bytes(4096);
    bytes.resize(*hand.line.read(0, bytes));
    hand.bus.receive(testing::damaged_stream({bytes}, 0.001, 0, random).bytes, hand.line.now());
    for (std::size_t k = 0; k < 6; ++k) {
      const ServoReport& report = hand.bus.reports()[k];
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
  EXPECT_LE(wrong, 2u);
}

TEST(FeetechBus, NoiseIsNoReport) {
  Random random(6);
  FeetechHand hand(FeetechSeries::kSts, 2);
  ASSERT_TRUE(hand.bus.start(hand.exchange));
  const double before = hand.line.now();
  for (int i = 0; i < 20'000; ++i) {
    Bytes noise;
    testing::append_noise(noise, random);
    hand.bus.receive(noise, before + 1.0);
  }
  for (const ServoReport& report : hand.bus.reports()) EXPECT_LE(report.time, before);
  hand.tick({kAsItIs, kAsItIs});
  EXPECT_GT(hand.bus.reports()[1].time, before);
}

TEST(FeetechBus, ATickAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP();
  for (const FeetechSeries series : kBothSeries) {
    FeetechHand hand(series, 8);
    ASSERT_TRUE(hand.bus.start(hand.exchange));
    const std::vector<double> positions(8, 512.0);
    Bytes bytes(4096);
    for (int i = 0; i < 5; ++i) {
      const testing::AllocationCounter ticking;
      const auto tick = hand.bus.tick(positions, 0.02);
      EXPECT_EQ(ticking.count(), 0u);
      ASSERT_TRUE(hand.exchange.send(tick));
      hand.exchange.pause(0.02);
      const auto arrived = std::span(bytes).first(*hand.line.read(0, bytes));
      ASSERT_GE(arrived.size(), 12u);
      const testing::AllocationCounter receiving;
      hand.bus.receive(arrived, hand.line.now());
      const auto next = hand.bus.follow_up();
      EXPECT_EQ(receiving.count(), 0u);
      EXPECT_EQ(next.empty(), series == FeetechSeries::kSts);
      ASSERT_TRUE(hand.exchange.send(next));
    }
    EXPECT_THROW(hand.bus.tick(std::vector<double>(3), 0.02), InvalidArgument);
  }
}

}  // namespace
}  // namespace somato::devices
