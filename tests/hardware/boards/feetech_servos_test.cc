#include "hardware/boards/feetech_servos.h"

#include <gtest/gtest.h>

#include <vector>

#include "hardware/support/servo_talk.h"

namespace somato::emulation {
namespace {

using testing::Bytes;
using testing::ServoTalk;
using wire::FeetechSeries;
namespace feetech = wire::feetech;

const Bytes kDoneByServo1{0xFF, 0xFF, 1, 2, 0, 0xFC};

TEST(FeetechServos, AnswersHaveTheBytesOfTheManual) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1304}, {.id = 2}});
  EXPECT_EQ(talk.ping(1), kDoneByServo1);
  EXPECT_EQ(talk.read(1, 0x38, 2), (Bytes{0xFF, 0xFF, 1, 4, 0, 0x18, 5, 0xDD}));
  EXPECT_EQ(talk.write(1, 0x2A, {0, 8, 0, 0, 0xE8, 3}), kDoneByServo1);
  EXPECT_TRUE(talk.ping(9).empty());
  talk.chain->set_measured(0, 2048, 0);
  talk.chain->set_measured(1, 2047, 0);
  talk.chain->store(0, 62, 1, 0x79);
  talk.chain->store(0, 63, 1, 0x1E);
  talk.chain->store(1, 62, 1, 0x77);
  talk.chain->store(1, 63, 1, 0x23);
  EXPECT_EQ(talk.exchange([](auto& to) { to.sync_read(0x38, 8, Bytes{1, 2}); }),
            (Bytes{0xFF, 0xFF, 1, 10, 0, 0,    8, 0, 0, 0, 0, 0x79, 0x1E, 0x55,
                   0xFF, 0xFF, 2, 10, 0, 0xFF, 7, 0, 0, 0, 0, 0x77, 0x23, 0x53}));
}

TEST(FeetechServos, TheSeriesDifferInOrderAndSyncRead) {
  ServoTalk talk(FeetechSeries::kScs, {{.id = 1, .model = 1284, .position = 0x0102}});
  EXPECT_EQ(talk.read(1, feetech::kModel, 2), (Bytes{0xFF, 0xFF, 1, 4, 0, 5, 4, 0xF1}));
  EXPECT_EQ(talk.read(1, feetech::kPresentPosition, 2), (Bytes{0xFF, 0xFF, 1, 4, 0, 1, 2, 0xF7}));
  EXPECT_TRUE(talk.exchange([](auto& to) { to.sync_read(56, 2, Bytes{1}); }).empty());
  ServoTalk sts(FeetechSeries::kSts, {{.id = 1}});
  EXPECT_EQ(sts.read(1, feetech::kModel, 2), (Bytes{0xFF, 0xFF, 1, 4, 0, 9, 3, 0xEE}));
}

TEST(FeetechServos, AGoalDrivesWithinTheLimits) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1500}});
  talk.write(1, feetech::kGoalPosition, {0xD0, 7});
  talk.write(1, feetech::kTorqueEnable, {1}, 0.0);
  EXPECT_EQ(talk.chain->driven_position(0), 2000.0);
  talk.write(1, feetech::kGoalPosition, {0x88, 0x13});  // 5000
  EXPECT_EQ(talk.chain->driven_position(0), 4095.0);
}

TEST(FeetechServos, StsServosMoveWithASpeed) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 1000}});
  talk.write(1, feetech::kGoalPosition, {0xE8, 3});
  talk.write(1, feetech::kTorqueEnable, {1});
  talk.exchange(
      [](auto& to) {
        to.begin_sync_write(feetech::kGoalPosition, 6);
        to.put8(1), to.put16(2000), to.put16(0), to.put16(1500);
        to.end();
      },
      0.1);
  EXPECT_NEAR(*talk.chain->driven_position(0), 1150.0, 1e-9);
}

TEST(FeetechServos, ScsServosMoveWithinATime) {
  ServoTalk talk(FeetechSeries::kScs, {{.id = 1, .position = 500}, {.id = 2, .position = 500}});
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
  EXPECT_NEAR(*talk.chain->driven_position(0), 550.0, 1e-9);
  EXPECT_NEAR(*talk.chain->driven_position(1), 510.0, 1e-9);
}

TEST(FeetechServos, TorqueStartsFromTheMeasuredPosition) {
  ServoTalk talk(FeetechSeries::kScs, {{.id = 1, .position = 500}});
  talk.write(1, feetech::kGoalPosition, {0x02, 0x58, 0, 200});  // 600 within 200 ms
  talk.write(1, feetech::kTorqueEnable, {1}, 0.1);
  EXPECT_NEAR(*talk.chain->driven_position(0), 550.0, 1e-9);
}

TEST(FeetechServos, MeasuredValuesAreReadInUnitsOfTheServo) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.chain->set_measured(0, -3.0, -65.0);
  const Bytes sent = talk.read(1, feetech::kPresentPosition, 15);
  ASSERT_EQ(sent.size(), 21u);
  EXPECT_EQ(Bytes(sent.begin() + 5, sent.begin() + 7), (Bytes{3, 0x80}));
  EXPECT_EQ(Bytes(sent.begin() + 18, sent.begin() + 20), (Bytes{10, 0x80}));
}

TEST(FeetechServos, AnOverloadIsAnnouncedByEachAnswer) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.chain->overload(0);
  const Bytes refused{0xFF, 0xFF, 1, 2, 0x20, 0xDC};
  EXPECT_EQ(talk.write(1, feetech::kTorqueEnable, {1}), refused);
}

TEST(FeetechServos, TheEepromKeepsWhatIsWrittenWhileItIsUnlocked) {
  for (const bool unlocked : {false, true}) {
    ServoTalk talk(FeetechSeries::kSts, {{.id = 1}});
    if (unlocked) talk.write(1, feetech::kLockSts, {0});
    talk.write(1, feetech::kId, {9});
    EXPECT_EQ(talk.chain->eeprom_writes(), 1u);
    EXPECT_EQ(talk.ping(9).size(), 6u);
    talk.chain->restart();
    talk.pass(1.0);
    EXPECT_EQ(talk.ping(9).size(), unlocked ? 6u : 0u);
    EXPECT_EQ(talk.ping(1).size(), unlocked ? 0u : 6u);
  }
}

TEST(FeetechServos, WhatItMeasuresCannotBeWritten) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1, .position = 700}});
  talk.write(1, feetech::kPresentPosition, {0, 0});
  EXPECT_EQ(talk.chain->stored(0, feetech::kPresentPosition, 2), 700);
}

TEST(FeetechServos, TheResponseLevelDecidesWhatIsAnswered) {
  ServoTalk talk(FeetechSeries::kSts, {{.id = 1}});
  talk.chain->store(0, feetech::kResponseLevel, 1, 0);
  EXPECT_TRUE(talk.write(1, feetech::kTorqueEnable, {1}).empty());
  EXPECT_TRUE(talk.chain->driven_position(0));
  EXPECT_EQ(talk.read(1, feetech::kId, 1).size(), 7u);
}

}  // namespace
}  // namespace somato::emulation
