#include "hardware/boards/dynamixel_servos.h"

#include <gtest/gtest.h>

#include <vector>

#include "hardware/support/packet_contents.h"
#include "hardware/support/servo_talk.h"

namespace somato::emulation {
namespace {

using testing::Bytes;
using testing::PacketContents;
using testing::ServoTalk;
namespace dynamixel_x = wire::dynamixel_x;
namespace dynamixel_error = wire::dynamixel_error;

PacketContents dynamixel_answers(const Bytes& bytes) {
  wire::DynamixelDecoder decoder;
  return testing::statuses(decoder, bytes);
}

TEST(DynamixelServos, APingIsAnsweredAsInTheManual) {
  ServoTalk talk({{.id = 1, .model = 1030}, {.id = 2, .model = 1030}});
  talk.chain->store(0, dynamixel_x::kFirmware, 1, 38);
  talk.chain->store(1, dynamixel_x::kFirmware, 1, 38);
  const Bytes one{0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 0x55, 0, 6, 4, 0x26, 0x65, 0x5D};
  const Bytes two{0xFF, 0xFF, 0xFD, 0, 2, 7, 0, 0x55, 0, 6, 4, 0x26, 0x6F, 0x6D};
  EXPECT_EQ(talk.ping(1), one);
  Bytes both = one;
  both.insert(both.end(), two.begin(), two.end());
  EXPECT_EQ(talk.ping(wire::kEveryone), both);
  EXPECT_TRUE(talk.ping(3).empty());
}

TEST(DynamixelServos, ReadAndSyncReadAreAnsweredAsInTheManual) {
  ServoTalk talk({{.id = 1, .position = 166}, {.id = 2, .position = 2079}});
  const Bytes one{0xFF, 0xFF, 0xFD, 0, 1, 8, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0};
  const Bytes two{0xFF, 0xFF, 0xFD, 0, 2, 8, 0, 0x55, 0, 0x1F, 8, 0, 0, 0xBA, 0xBE};
  EXPECT_EQ(talk.read(1, 132, 4), one);
  Bytes both = one;
  both.insert(both.end(), two.begin(), two.end());
  EXPECT_EQ(talk.exchange([](auto& to) { to.sync_read(132, 4, Bytes{1, 7, 2}); }), both);
}

// It starts where the servo is, and not where it was driven before.
TEST(DynamixelServos, TorqueStartsFromTheMeasuredPosition) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1, .position = 1500}});
  talk.write(1, dynamixel_x::kVelocity, {1, 0, 0, 0});
  talk.write(1, dynamixel_x::kGoalPosition, {0xE8, 3, 0, 0});
  talk.write(1, dynamixel_x::kTorqueEnable, {1}, 0.0);
  EXPECT_EQ(talk.chain->driven_position(0), 1500.0);
  talk.pass(1.0);
  EXPECT_NEAR(*talk.chain->driven_position(0), 1484.37, 0.01);
}

TEST(DynamixelServos, TheProfileVelocityRampsTheGoal) {
  ServoTalk talk({{.id = 1, .position = 1000}, {.id = 2, .position = 1000}});
  for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}}) {
    talk.write(id, dynamixel_x::kGoalPosition, {0xE8, 3, 0, 0});
    talk.write(id, dynamixel_x::kTorqueEnable, {1});
  }
  // 10 units of 0.229 rev/min are 2.29 / 60 * 4096 = 156.33 steps/s.
  talk.exchange(
      [](auto& to) {
        to.begin_sync_write(dynamixel_x::kVelocity, 8);
        to.put8(1), to.put32(10), to.put32(2000);
        to.put8(2), to.put32(0), to.put32(2000);
        to.end();
      },
      1.0);
  EXPECT_NEAR(*talk.chain->driven_position(0), 1156.33, 0.01);
  EXPECT_EQ(talk.chain->driven_position(1), 2000.0);
  talk.pass(10.0);
  EXPECT_EQ(talk.chain->driven_position(0), 2000.0);
}

TEST(DynamixelServos, ATimedProfileArrivesInItsTime) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1, .position = 1000}});
  talk.write(1, dynamixel_x::kDriveMode, {dynamixel_x::kTimeBasedProfile});
  talk.write(1, dynamixel_x::kGoalPosition, {0xE8, 3, 0, 0});
  talk.write(1, dynamixel_x::kTorqueEnable, {1});
  talk.exchange(
      [](auto& to) {
        to.begin_sync_write(dynamixel_x::kVelocity, 8);
        to.put8(1), to.put32(500), to.put32(2000);
        to.end();
      },
      0.25);
  EXPECT_NEAR(*talk.chain->driven_position(0), 1500.0, 1e-6);
}

TEST(DynamixelServos, MeasuredValuesAreReadInUnitsOfTheServo) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1, .current_unit = 2.69}});
  talk.chain->set_measured(0, -3.4, -269.0);
  const auto all = dynamixel_answers(talk.read(1, dynamixel_x::kPresentCurrent, 10));
  EXPECT_EQ(all, (PacketContents{{1, 0, {0x9C, 0xFF, 0, 0, 0, 0, 0xFD, 0xFF, 0xFF, 0xFF}}}));
}

TEST(DynamixelServos, AnOverloadIsAnnouncedByEachAnswer) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1}});
  talk.chain->overload(0);
  EXPECT_EQ(dynamixel_answers(talk.read(1, dynamixel_x::kHardwareError, 1)),
            (PacketContents{{1, dynamixel_error::kAlert, {dynamixel_x::kOverload}}}));
  EXPECT_EQ(dynamixel_answers(talk.write(1, dynamixel_x::kTorqueEnable, {1})),
            (PacketContents{{1, dynamixel_error::kAlert | dynamixel_error::kResult, {}}}));
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.reboot(1); })).size(), 1u);
}

TEST(DynamixelServos, WhatCannotBeWrittenIsRefused) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1}});
  const auto refusal = [&](std::uint16_t address, const Bytes& data) {
    const auto all = dynamixel_answers(talk.write(1, address, data));
    return all.size() == 1 ? all[0].error : -1;
  };
  EXPECT_EQ(refusal(dynamixel_x::kPresentPosition, {0, 0, 0, 0}), dynamixel_error::kAccess);
  EXPECT_EQ(refusal(dynamixel_x::kTorqueEnable, {2}), dynamixel_error::kRange);
  EXPECT_EQ(refusal(dynamixel_x::kGoalPosition, {0, 0x10, 0, 0}), dynamixel_error::kLimit);
  EXPECT_EQ(refusal(dynamixel_x::kGoalPosition, {0xFF, 0xFF, 0xFF, 0xFF}), dynamixel_error::kLimit);
  EXPECT_EQ(refusal(dynamixel_x::kReturnDelay, {0}), 0);
  EXPECT_EQ(talk.chain->eeprom_writes(), 1u);
  EXPECT_EQ(refusal(dynamixel_x::kTorqueEnable, {1}), 0);
  EXPECT_EQ(refusal(dynamixel_x::kReturnDelay, {1}), dynamixel_error::kAccess);
  EXPECT_EQ(talk.chain->eeprom_writes(), 1u);
  EXPECT_EQ(dynamixel_answers(talk.read(1, 300, 4)),
            (PacketContents{{1, dynamixel_error::kAccess, {}}}));
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.action(1); })),
            (PacketContents{{1, dynamixel_error::kInstruction, {}}}));
}

TEST(DynamixelServos, TheStatusReturnLevelDecidesWhatIsAnswered) {
  ServoTalk talk(std::vector<EmulatedDynamixel>{{.id = 1}});
  std::vector<std::size_t> counts;
  for (const std::uint32_t level : {0U, 1U, 2U}) {
    talk.chain->store(0, dynamixel_x::kStatusReturn, 1, level);
    const Bytes sent = talk.exchange([](auto& to) {
      to.ping(1);
      to.read(1, 132, 4);
      to.write(1, 65, Bytes{1});
    });
    counts.push_back(dynamixel_answers(sent).size());
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(DynamixelServos, AnswersWaitForTheReturnDelay) {
  ServoTalk talk({{.id = 1, .return_delay = 250}, {.id = 2, .return_delay = 100}});
  const auto request = [](auto& to) { to.sync_read(132, 4, Bytes{1, 2}); };
  EXPECT_TRUE(talk.exchange(request, 0.000499).empty());
  EXPECT_EQ(dynamixel_answers(talk.pass(0.000002)).size(), 1u);
  EXPECT_TRUE(talk.pass(0.000198).empty());
  EXPECT_EQ(dynamixel_answers(talk.pass(0.000002)).size(), 1u);
}

}  // namespace
}  // namespace somato::emulation
