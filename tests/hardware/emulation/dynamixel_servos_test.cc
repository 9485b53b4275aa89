#include "hardware/emulation/dynamixel_servos.h"

#include <gtest/gtest.h>

#include <vector>

#include "hardware/protocols/dynamixel.h"
#include "hardware/support/damaged_streams.h"
#include "somato/core/random.h"

namespace somato::emulation {
namespace {

using testing::Bytes;
namespace dynamixel_x = wire::dynamixel_x;
namespace dynamixel_error = wire::dynamixel_error;

// A chain of servos and a host that talks to them.
struct DynamixelTalk {
  DynamixelTalk(const std::vector<EmulatedDynamixel>& servos, bool echo) : chain(servos, echo) {}

  template <typename Fill>
  Bytes exchange(const Fill& fill, double seconds = 0.01) {
    Bytes memory(4096);
    wire::DynamixelWriter writer(memory);
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

  void write(std::uint8_t id, std::uint16_t address, const Bytes& data) {
    exchange([&](auto& to) { to.write(id, address, data); });
  }

  DynamixelServos chain;
  double now = 0.0;
};

struct DynamixelAnswer {
  int id = 0;
  int error = 0;
  Bytes data;
  bool operator==(const DynamixelAnswer&) const = default;
};

std::vector<DynamixelAnswer> dynamixel_answers(const Bytes& bytes) {
  wire::DynamixelDecoder decoder;
  decoder.put(bytes);
  std::vector<DynamixelAnswer> all;
  while (const auto packet = decoder.next_status()) {
    all.push_back(
        {packet->id, packet->error, Bytes(packet->parameters.begin(), packet->parameters.end())});
  }
  return all;
}

using DynamixelAnswers = std::vector<DynamixelAnswer>;

TEST(DynamixelServos, APingIsAnsweredAsInTheManual) {
  DynamixelTalk talk({{.id = 1, .model = 1030}, {.id = 2, .model = 1030}}, false);
  talk.chain.store(0, dynamixel_x::kFirmware, 1, 38);
  talk.chain.store(1, dynamixel_x::kFirmware, 1, 38);
  const Bytes one{0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 0x55, 0, 6, 4, 0x26, 0x65, 0x5D};
  const Bytes two{0xFF, 0xFF, 0xFD, 0, 2, 7, 0, 0x55, 0, 6, 4, 0x26, 0x6F, 0x6D};
  EXPECT_EQ(talk.exchange([](auto& to) { to.ping(1); }), one);
  Bytes both = one;
  both.insert(both.end(), two.begin(), two.end());
  EXPECT_EQ(talk.exchange([](auto& to) { to.ping(wire::kEveryone); }), both);
  EXPECT_TRUE(talk.exchange([](auto& to) { to.ping(3); }).empty());
}

TEST(DynamixelServos, ReadAndSyncReadAreAnsweredAsInTheManual) {
  DynamixelTalk talk({{.id = 1, .position = 166}, {.id = 2, .position = 2079}}, false);
  const Bytes one{0xFF, 0xFF, 0xFD, 0, 1, 8, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0};
  const Bytes two{0xFF, 0xFF, 0xFD, 0, 2, 8, 0, 0x55, 0, 0x1F, 8, 0, 0, 0xBA, 0xBE};
  EXPECT_EQ(talk.exchange([](auto& to) { to.read(1, 132, 4); }), one);
  Bytes both = one;
  both.insert(both.end(), two.begin(), two.end());
  EXPECT_EQ(talk.exchange([](auto& to) { to.sync_read(132, 4, Bytes{1, 7, 2}); }), both);
}

TEST(DynamixelServos, AGoalDrivesOnlyWithTorque) {
  DynamixelTalk talk({{.id = 1}}, false);
  talk.write(1, dynamixel_x::kGoalPosition, {0xE8, 3, 0, 0});
  EXPECT_FALSE(talk.chain.driven_position(0));
  talk.write(1, dynamixel_x::kTorqueEnable, {1});
  EXPECT_EQ(talk.chain.driven_position(0), 1000.0);
  talk.write(wire::kEveryone, dynamixel_x::kTorqueEnable, {0});
  EXPECT_FALSE(talk.chain.driven_position(0));
}

// It starts where the servo is, and not where it was driven before.
TEST(DynamixelServos, TorqueStartsFromTheMeasuredPosition) {
  DynamixelTalk talk({{.id = 1, .position = 1500}}, false);
  talk.write(1, dynamixel_x::kVelocity, {1, 0, 0, 0});
  talk.write(1, dynamixel_x::kGoalPosition, {0xE8, 3, 0, 0});
  talk.exchange([](auto& to) { to.write(1, dynamixel_x::kTorqueEnable, Bytes{1}); }, 0.0);
  EXPECT_EQ(talk.chain.driven_position(0), 1500.0);
  Bytes sent;
  talk.pass(1.0, sent);
  EXPECT_NEAR(*talk.chain.driven_position(0), 1484.37, 0.01);
}

TEST(DynamixelServos, TheProfileVelocityRampsTheGoal) {
  DynamixelTalk talk({{.id = 1, .position = 1000}, {.id = 2, .position = 1000}}, false);
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
  EXPECT_NEAR(*talk.chain.driven_position(0), 1156.33, 0.01);
  EXPECT_EQ(talk.chain.driven_position(1), 2000.0);
  Bytes sent;
  talk.pass(10.0, sent);
  EXPECT_EQ(talk.chain.driven_position(0), 2000.0);
}

TEST(DynamixelServos, ATimedProfileArrivesInItsTime) {
  DynamixelTalk talk({{.id = 1, .position = 1000}}, false);
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
  EXPECT_NEAR(*talk.chain.driven_position(0), 1500.0, 1e-6);
}

TEST(DynamixelServos, MeasuredValuesAreReadInUnitsOfTheServo) {
  DynamixelTalk talk({{.id = 1, .current_unit = 2.69}}, false);
  talk.chain.set_measured(0, -3.4, -269.0);
  const auto all = dynamixel_answers(
      talk.exchange([](auto& to) { to.read(1, dynamixel_x::kPresentCurrent, 10); }));
  EXPECT_EQ(all, (DynamixelAnswers{{1, 0, {0x9C, 0xFF, 0, 0, 0, 0, 0xFD, 0xFF, 0xFF, 0xFF}}}));
}

TEST(DynamixelServos, AnOverloadEndsOnlyWithAReboot) {
  DynamixelTalk talk({{.id = 1}}, false);
  talk.write(1, dynamixel_x::kTorqueEnable, {1});
  talk.chain.overload(0);
  EXPECT_FALSE(talk.chain.driven_position(0));
  EXPECT_EQ(dynamixel_answers(
                talk.exchange([](auto& to) { to.read(1, dynamixel_x::kHardwareError, 1); })),
            (DynamixelAnswers{{1, dynamixel_error::kAlert, {dynamixel_x::kOverload}}}));
  EXPECT_EQ(dynamixel_answers(
                talk.exchange([](auto& to) { to.write(1, dynamixel_x::kTorqueEnable, Bytes{1}); })),
            (DynamixelAnswers{{1, dynamixel_error::kAlert | dynamixel_error::kResult, {}}}));
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.reboot(1); })).size(), 1u);
  EXPECT_TRUE(talk.exchange([](auto& to) { to.ping(1); }).empty());  // it boots
  Bytes sent;
  talk.pass(1.0, sent);
  talk.write(1, dynamixel_x::kTorqueEnable, {1});
  EXPECT_TRUE(talk.chain.driven_position(0));
}

TEST(DynamixelServos, WhatCannotBeWrittenIsRefused) {
  DynamixelTalk talk({{.id = 1}}, false);
  const auto refusal = [&](std::uint16_t address, const Bytes& data) {
    const auto all =
        dynamixel_answers(talk.exchange([&](auto& to) { to.write(1, address, data); }));
    return all.size() == 1 ? all[0].error : -1;
  };
  EXPECT_EQ(refusal(dynamixel_x::kPresentPosition, {0, 0, 0, 0}), dynamixel_error::kAccess);
  EXPECT_EQ(refusal(dynamixel_x::kTorqueEnable, {2}), dynamixel_error::kRange);
  EXPECT_EQ(refusal(dynamixel_x::kGoalPosition, {0, 0x10, 0, 0}), dynamixel_error::kLimit);
  EXPECT_EQ(refusal(dynamixel_x::kGoalPosition, {0xFF, 0xFF, 0xFF, 0xFF}), dynamixel_error::kLimit);
  EXPECT_EQ(refusal(dynamixel_x::kReturnDelay, {0}), 0);
  EXPECT_EQ(talk.chain.eeprom_writes(), 1u);
  EXPECT_EQ(refusal(dynamixel_x::kTorqueEnable, {1}), 0);
  EXPECT_EQ(refusal(dynamixel_x::kReturnDelay, {1}), dynamixel_error::kAccess);
  EXPECT_EQ(talk.chain.eeprom_writes(), 1u);
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.read(1, 300, 4); })),
            (DynamixelAnswers{{1, dynamixel_error::kAccess, {}}}));
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.action(1); })),
            (DynamixelAnswers{{1, dynamixel_error::kInstruction, {}}}));
}

TEST(DynamixelServos, ARegisteredWriteWaitsForTheAction) {
  DynamixelTalk talk({{.id = 1}}, false);
  talk.exchange([](auto& to) { to.reg_write(1, dynamixel_x::kTorqueEnable, Bytes{1}); });
  EXPECT_FALSE(talk.chain.driven_position(0));
  talk.exchange([](auto& to) { to.action(wire::kEveryone); });
  EXPECT_TRUE(talk.chain.driven_position(0));
}

TEST(DynamixelServos, TheStatusReturnLevelDecidesWhatIsAnswered) {
  DynamixelTalk talk({{.id = 1}}, false);
  std::vector<std::size_t> counts;
  for (const std::uint32_t level : {0U, 1U, 2U}) {
    talk.chain.store(0, dynamixel_x::kStatusReturn, 1, level);
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
  DynamixelTalk talk({{.id = 1, .return_delay = 250}, {.id = 2, .return_delay = 100}}, false);
  const auto request = [](auto& to) { to.sync_read(132, 4, Bytes{1, 2}); };
  EXPECT_TRUE(talk.exchange(request, 0.000499).empty());
  Bytes sent;
  talk.pass(0.000002, sent);
  EXPECT_EQ(dynamixel_answers(sent).size(), 1u);
  talk.pass(0.000198, sent);
  EXPECT_EQ(dynamixel_answers(sent).size(), 1u);
  talk.pass(0.000002, sent);
  EXPECT_EQ(dynamixel_answers(sent).size(), 2u);
}

TEST(DynamixelServos, AnEchoComesBeforeTheAnswer) {
  DynamixelTalk talk({{.id = 1}}, true);
  const Bytes sent = talk.exchange([](auto& to) { to.ping(1); });
  const Bytes echo{0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 1, 0x19, 0x4E};
  ASSERT_GT(sent.size(), echo.size());
  EXPECT_TRUE(std::equal(echo.begin(), echo.end(), sent.begin()));
  EXPECT_EQ(dynamixel_answers(sent).size(), 1u);
}

TEST(DynamixelServos, ASilentServoAndARestartedChainDoNotAnswer) {
  DynamixelTalk talk({{.id = 1}, {.id = 2}}, false);
  talk.chain.set_silent(0, true);
  EXPECT_EQ(
      dynamixel_answers(talk.exchange([](auto& to) { to.sync_read(132, 4, Bytes{1, 2}); })).size(),
      1u);
  talk.write(2, dynamixel_x::kTorqueEnable, {1});
  talk.chain.restart();
  EXPECT_FALSE(talk.chain.driven_position(1));
  EXPECT_TRUE(talk.exchange([](auto& to) { to.ping(2); }).empty());
  Bytes sent;
  talk.pass(1.0, sent);
  EXPECT_EQ(dynamixel_answers(talk.exchange([](auto& to) { to.ping(2); })).size(), 1u);
}

// Packets with any instruction and parameters, and noise between them.
TEST(DynamixelServos, NoPacketDoesHarm) {
  Random random(5);
  DynamixelTalk talk({{.id = 1}, {.id = 2}}, true);
  std::size_t answered = 0;
  for (int i = 0; i < 5000; ++i) {
    const Bytes sent = talk.exchange([&](auto& to) {
      const std::uint8_t ids[] = {1, 2, 3, wire::kEveryone};
      const std::uint8_t common[] = {1, 2, 3, 4, 5, 8, 0x82, 0x83, 0x10};
      const auto instruction = static_cast<wire::PacketInstruction>(common[random.below(9)]);
      to.begin(ids[random.below(4)], instruction);
      for (std::uint64_t left = random.below(20); left > 0; --left) {
        to.put8(random.below(3) == 0 ? testing::random_byte(random)
                                     : static_cast<std::uint8_t>(random.below(5)));
      }
      to.end();
    });
    Bytes noise;
    testing::append_noise(noise, random);
    talk.chain.receive(noise);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto driven = talk.chain.driven_position(k);
      ASSERT_TRUE(!driven || (*driven >= 0.0 && *driven <= 4095.0));
    }
    answered += dynamixel_answers(sent).size();
    if (random.below(50) == 0) talk.chain.restart();
    Bytes later;
    if (random.below(3) == 0) talk.pass(0.5, later);
  }
  EXPECT_GT(answered, 500u);
}

}  // namespace
}  // namespace somato::emulation
