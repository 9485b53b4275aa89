#include "hardware/emulation/feetech_servos.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardware/protocols/feetech.h"
#include "hardware/support/damaged_streams.h"
#include "somato/core/random.h"

namespace somato::emulation {
namespace {

using testing::Bytes;
using wire::FeetechSeries;
namespace feetech = wire::feetech;

// A chain of servos and a host that talks to them.
struct FeetechTalk {
  FeetechTalk(FeetechSeries kind, const std::vector<EmulatedFeetech>& servos, bool echo = false)
      : series(kind), chain(kind, servos, echo) {}

  template <typename Fill>
  Bytes exchange(const Fill& fill, double seconds = 0.01) {
    Bytes memory(4096);
    wire::FeetechWriter writer(memory, wire::feetech_order(series));
    fill(writer);
    Bytes sent;
    chain.receive(writer.written());
    pass(seconds, sent);
    return sent;
  }

  void pass(double seconds, Bytes& sent) {
    now += seconds;
    chain.advance(now, sent);
  }

  Bytes write(std::uint8_t id, std::uint8_t address, const Bytes& data) {
    return exchange([&](auto& to) { to.write(id, address, data); });
  }

  FeetechSeries series;
  FeetechServos chain;
  double now = 0.0;
};

const Bytes kDoneByServo1{0xFF, 0xFF, 1, 2, 0, 0xFC};

TEST(FeetechServos, AnswersHaveTheBytesOfTheManual) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1304}, {.id = 2}});
  EXPECT_EQ(talk.exchange([](auto& to) { to.ping(1); }), kDoneByServo1);
  EXPECT_EQ(talk.exchange([](auto& to) { to.read(1, 0x38, 2); }),
            (Bytes{0xFF, 0xFF, 1, 4, 0, 0x18, 5, 0xDD}));
  EXPECT_EQ(talk.write(1, 0x2A, {0, 8, 0, 0, 0xE8, 3}), kDoneByServo1);
  EXPECT_TRUE(talk.exchange([](auto& to) { to.ping(9); }).empty());
  talk.chain.set_measured(0, 2048, 0);
  talk.chain.set_measured(1, 2047, 0);
  talk.chain.store(0, 62, 1, 0x79);
  talk.chain.store(0, 63, 1, 0x1E);
  talk.chain.store(1, 62, 1, 0x77);
  talk.chain.store(1, 63, 1, 0x23);
  EXPECT_EQ(talk.exchange([](auto& to) { to.sync_read(0x38, 8, Bytes{1, 2}); }),
            (Bytes{0xFF, 0xFF, 1, 10, 0, 0,    8, 0, 0, 0, 0, 0x79, 0x1E, 0x55,
                   0xFF, 0xFF, 2, 10, 0, 0xFF, 7, 0, 0, 0, 0, 0x77, 0x23, 0x53}));
}

TEST(FeetechServos, TheSeriesDifferInOrderAndSyncRead) {
  FeetechTalk talk(FeetechSeries::kScs, {{.id = 1, .model = 1284, .position = 0x0102}});
  EXPECT_EQ(talk.exchange([](auto& to) { to.read(1, feetech::kModel, 2); }),
            (Bytes{0xFF, 0xFF, 1, 4, 0, 5, 4, 0xF1}));
  EXPECT_EQ(talk.exchange([](auto& to) { to.read(1, feetech::kPresentPosition, 2); }),
            (Bytes{0xFF, 0xFF, 1, 4, 0, 1, 2, 0xF7}));
  EXPECT_TRUE(talk.exchange([](auto& to) { to.sync_read(56, 2, Bytes{1}); }).empty());
  FeetechTalk sts(FeetechSeries::kSts, {{.id = 1}});
  EXPECT_EQ(sts.exchange([](auto& to) { to.read(1, feetech::kModel, 2); }),
            (Bytes{0xFF, 0xFF, 1, 4, 0, 9, 3, 0xEE}));
}

TEST(FeetechServos, AGoalDrivesOnlyWithTorqueAndWithinTheLimits) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1500}});
  talk.write(1, feetech::kGoalPosition, {0xD0, 7});
  EXPECT_FALSE(talk.chain.driven_position(0));
  talk.exchange([](auto& to) { to.write(1, feetech::kTorqueEnable, Bytes{1}); }, 0.0);
  EXPECT_EQ(talk.chain.driven_position(0), 2000.0);
  talk.write(1, feetech::kGoalPosition, {0x88, 0x13});  // 5000
  EXPECT_EQ(talk.chain.driven_position(0), 4095.0);
  talk.write(wire::kEveryone, feetech::kTorqueEnable, {0});
  EXPECT_FALSE(talk.chain.driven_position(0));
}

TEST(FeetechServos, StsServosMoveWithASpeed) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1000}});
  talk.write(1, feetech::kGoalPosition, {0xE8, 3});
  talk.write(1, feetech::kTorqueEnable, {1});
  talk.exchange(
      [](auto& to) {
        to.begin_sync_write(feetech::kGoalPosition, 6);
        to.put8(1), to.put16(2000), to.put16(0), to.put16(1500);
        to.end();
      },
      0.1);
  EXPECT_NEAR(*talk.chain.driven_position(0), 1150.0, 1e-9);
}

TEST(FeetechServos, ScsServosMoveWithinATime) {
  FeetechTalk talk(FeetechSeries::kScs, {{.id = 1, .position = 500}, {.id = 2, .position = 500}});
  for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}}) {
    talk.write(id, feetech::kGoalPosition, {1, 0xF4});
    talk.write(id, feetech::kTorqueEnable, {1});
  }
  talk.exchange(
      [](auto& to) {
        to.begin_sync_write(feetech::kGoalPosition, 6);
        to.put8(1), to.put16(600), to.put16(200), to.put16(0);
        to.put8(2), to.put16(600), to.put16(0), to.put16(100);
        to.end();
      },
      0.1);
  EXPECT_NEAR(*talk.chain.driven_position(0), 550.0, 1e-9);
  EXPECT_NEAR(*talk.chain.driven_position(1), 510.0, 1e-9);
}

TEST(FeetechServos, TorqueStartsFromTheMeasuredPosition) {
  FeetechTalk talk(FeetechSeries::kScs, {{.id = 1, .position = 500}});
  talk.write(1, feetech::kGoalPosition, {0x02, 0x58, 0, 200});  // 600 within 200 ms
  talk.exchange([](auto& to) { to.write(1, feetech::kTorqueEnable, Bytes{1}); }, 0.1);
  EXPECT_NEAR(*talk.chain.driven_position(0), 550.0, 1e-9);
}

TEST(FeetechServos, MeasuredValuesAreReadInUnitsOfTheServo) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.chain.set_measured(0, -3.0, -65.0);
  const Bytes sent = talk.exchange([](auto& to) { to.read(1, feetech::kPresentPosition, 15); });
  ASSERT_EQ(sent.size(), 21u);
  EXPECT_EQ(Bytes(sent.begin() + 5, sent.begin() + 7), (Bytes{3, 0x80}));
  EXPECT_EQ(Bytes(sent.begin() + 18, sent.begin() + 20), (Bytes{10, 0x80}));
}

TEST(FeetechServos, AnOverloadEndsOnlyWithAReboot) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.write(1, feetech::kTorqueEnable, {1});
  talk.chain.overload(0);
  EXPECT_FALSE(talk.chain.driven_position(0));
  const Bytes refused = talk.write(1, feetech::kTorqueEnable, {1});
  EXPECT_EQ(refused, (Bytes{0xFF, 0xFF, 1, 2, 0x20, 0xDC}));
  EXPECT_FALSE(talk.chain.driven_position(0));
  EXPECT_TRUE(talk.exchange([](auto& to) { to.reboot(1); }).empty());
  EXPECT_TRUE(talk.exchange([](auto& to) { to.ping(1); }).empty());  // it boots
  Bytes sent;
  talk.pass(1.0, sent);
  EXPECT_EQ(talk.write(1, feetech::kTorqueEnable, {1}), kDoneByServo1);
  EXPECT_TRUE(talk.chain.driven_position(0));
}

TEST(FeetechServos, TheEepromKeepsWhatIsWrittenWhileItIsUnlocked) {
  for (const bool unlocked : {false, true}) {
    FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}});
    if (unlocked) talk.write(1, feetech::kLockSts, {0});
    talk.write(1, feetech::kId, {9});
    EXPECT_EQ(talk.chain.eeprom_writes(), 1u);
    EXPECT_EQ(talk.exchange([](auto& to) { to.ping(9); }).size(), 6u);
    talk.chain.restart();
    Bytes sent;
    talk.pass(1.0, sent);
    EXPECT_EQ(talk.exchange([](auto& to) { to.ping(9); }).size(), unlocked ? 6u : 0u);
    EXPECT_EQ(talk.exchange([](auto& to) { to.ping(1); }).size(), unlocked ? 0u : 6u);
  }
}

TEST(FeetechServos, WhatItMeasuresCannotBeWritten) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 700}});
  talk.write(1, feetech::kPresentPosition, {0, 0});
  EXPECT_EQ(talk.chain.stored(0, feetech::kPresentPosition, 2), 700);
}

TEST(FeetechServos, ARegisteredWriteWaitsForTheAction) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}});
  EXPECT_EQ(talk.exchange([](auto& to) { to.reg_write(1, feetech::kTorqueEnable, Bytes{1}); }),
            kDoneByServo1);
  EXPECT_FALSE(talk.chain.driven_position(0));
  EXPECT_TRUE(talk.exchange([](auto& to) { to.action(wire::kEveryone); }).empty());
  EXPECT_TRUE(talk.chain.driven_position(0));
}

TEST(FeetechServos, TheResponseLevelDecidesWhatIsAnswered) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.chain.store(0, feetech::kResponseLevel, 1, 0);
  EXPECT_TRUE(talk.write(1, feetech::kTorqueEnable, {1}).empty());
  EXPECT_TRUE(talk.chain.driven_position(0));
  EXPECT_EQ(talk.exchange([](auto& to) { to.read(1, feetech::kId, 1); }).size(), 7u);
}

TEST(FeetechServos, AnEchoComesFirstAndAnswersWaitForTheReturnDelay) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1, .return_delay = 250}}, true);
  const Bytes echo{0xFF, 0xFF, 1, 2, 1, 0xFB};
  EXPECT_EQ(talk.exchange([](auto& to) { to.ping(1); }, 0.0004), echo);
  Bytes sent;
  talk.pass(0.0002, sent);
  EXPECT_EQ(sent, kDoneByServo1);
}

TEST(FeetechServos, ASilentServoDoesNotAnswer) {
  FeetechTalk talk(FeetechSeries::kSts, {{.id = 1}, {.id = 2}});
  talk.chain.set_silent(0, true);
  EXPECT_EQ(talk.exchange([](auto& to) { to.sync_read(56, 2, Bytes{1, 2}); }).size(), 8u);
}

// Packets with any instruction and parameters, and noise between them.
TEST(FeetechServos, NoPacketDoesHarm) {
  for (const FeetechSeries series : {FeetechSeries::kSts, FeetechSeries::kScs}) {
    Random random(5);
    FeetechTalk talk(series, {{.id = 1}, {.id = 2}}, true);
    std::size_t answered = 0;
    for (int i = 0; i < 5000; ++i) {
      const Bytes sent = talk.exchange([&](auto& to) {
        const std::uint8_t ids[] = {1, 2, 3, wire::kEveryone};
        const std::uint8_t common[] = {1, 2, 3, 4, 5, 8, 0x82, 0x83, 0x10};
        to.begin(ids[random.below(4)], common[random.below(9)]);
        for (std::uint64_t left = random.below(20); left > 0; --left) {
          to.put8(random.below(3) == 0 ? testing::random_byte(random)
                                       : static_cast<std::uint8_t>(random.below(5)));
        }
        to.end();
      });
      answered += sent.size() > 30 ? 1 : 0;
      Bytes noise;
      testing::append_noise(noise, random);
      talk.chain.receive(noise);
      for (std::size_t k = 0; k < 2; ++k) {
        const auto driven = talk.chain.driven_position(k);
        ASSERT_TRUE(!driven || std::abs(*driven) <= 65535.0);
      }
      if (random.below(50) == 0) talk.chain.restart();
      Bytes later;
      if (random.below(3) == 0) talk.pass(1.0, later);
    }
    EXPECT_GT(answered, 300u);
  }
}

}  // namespace
}  // namespace somato::emulation
