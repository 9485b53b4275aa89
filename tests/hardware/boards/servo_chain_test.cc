#include "hardware/boards/servo_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardware/buses/bus_kind.h"
#include "hardware/support/servo_talk.h"
#include "somato/core/random.h"

namespace somato::emulation {
namespace {

using devices::BusKind;
using testing::Bytes;
using testing::ServoTalk;
using wire::FeetechSeries;
namespace dynamixel_x = wire::dynamixel_x;
namespace feetech = wire::feetech;

class ServoChainTest : public ::testing::TestWithParam<BusKind> {
 protected:
  static bool is_dynamixel() { return GetParam() == BusKind::kDynamixel; }

  // Servos with the ids 1 and 2 at the position 500.
  static ServoTalk talk(bool echo = false, std::uint8_t delay = 0) {
    if (is_dynamixel()) {
      const auto servo = [&](std::uint8_t id) {
        return EmulatedDynamixel{.id = id, .position = 500, .return_delay = delay};
      };
      return ServoTalk({servo(1), servo(2)}, echo);
    }
    const auto servo = [&](std::uint8_t id) {
      return EmulatedFeetech{.id = id, .position = 500, .return_delay = delay};
    };
    const bool sts = GetParam() == BusKind::kSts;
    return {sts ? FeetechSeries::kSts : FeetechSeries::kScs, {servo(1), servo(2)}, echo};
  }

  const std::uint16_t torque = is_dynamixel() ? dynamixel_x::kTorqueEnable : feetech::kTorqueEnable;
  const std::uint16_t goal = is_dynamixel() ? dynamixel_x::kGoalPosition : feetech::kGoalPosition;

  // The answer of servo 1 that it has done what it received.
  const Bytes done = is_dynamixel() ? Bytes{0xFF, 0xFF, 0xFD, 0, 1, 4, 0, 0x55, 0, 0xA1, 0x0C}
                                    : Bytes{0xFF, 0xFF, 1, 2, 0, 0xFC};
  const Bytes echo_of_ping = is_dynamixel() ? Bytes{0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 1, 0x19, 0x4E}
                                            : Bytes{0xFF, 0xFF, 1, 2, 1, 0xFB};
};

INSTANTIATE_TEST_SUITE_P(Kinds, ServoChainTest,
                         ::testing::Values(BusKind::kDynamixel, BusKind::kSts, BusKind::kScs),
                         [](const auto& kind) { return devices::traits_of(kind.param).name; });

TEST_P(ServoChainTest, AGoalDrivesOnlyWithTorque) {
  ServoTalk host = talk();
  host.exchange([&](auto& to) {
    to.begin_sync_write(goal, is_dynamixel() ? 4 : 2);
    to.put8(1);
    is_dynamixel() ? to.put32(1000) : to.put16(1000);
    to.end();
  });
  EXPECT_FALSE(host.chain->driven_position(0));
  host.write(1, torque, {1});
  EXPECT_EQ(host.chain->driven_position(0), 1000.0);
  EXPECT_FALSE(host.chain->driven_position(1));
  host.write(wire::kEveryone, torque, {0});
  EXPECT_FALSE(host.chain->driven_position(0));
}

TEST_P(ServoChainTest, AnOverloadEndsOnlyWithAReboot) {
  ServoTalk host = talk();
  EXPECT_EQ(host.write(1, torque, {1}), done);
  host.chain->overload(0);
  EXPECT_FALSE(host.chain->driven_position(0));
  EXPECT_NE(host.write(1, torque, {1}), done);
  EXPECT_FALSE(host.chain->driven_position(0));
  EXPECT_EQ(host.exchange([](auto& to) { to.reboot(1); }).empty(), !is_dynamixel());
  EXPECT_TRUE(host.ping(1).empty());  // it boots
  host.pass(1.0);
  EXPECT_EQ(host.write(1, torque, {1}), done);
  EXPECT_TRUE(host.chain->driven_position(0));
}

TEST_P(ServoChainTest, ARegisteredWriteWaitsForTheAction) {
  ServoTalk host = talk();
  EXPECT_EQ(host.exchange([&](auto& to) { to.reg_write(1, torque, Bytes{1}); }), done);
  EXPECT_FALSE(host.chain->driven_position(0));
  EXPECT_TRUE(host.exchange([](auto& to) { to.action(wire::kEveryone); }).empty());
  EXPECT_TRUE(host.chain->driven_position(0));
}

TEST_P(ServoChainTest, AnEchoComesFirstAndAnswersWaitForTheReturnDelay) {
  ServoTalk host = talk(true, 250);
  EXPECT_EQ(host.ping(1, 0.0004), echo_of_ping);
  const Bytes later = host.pass(0.0002);
  const Bytes answer = talk().ping(1);
  EXPECT_FALSE(answer.empty());
  EXPECT_EQ(later, answer);
}

TEST_P(ServoChainTest, ASilentServoAndARestartedChainDoNotAnswer) {
  ServoTalk host = talk();
  host.chain->set_silent(0, true);
  EXPECT_TRUE(host.ping(1).empty());
  const std::size_t one = host.ping(2).size();
  const auto request = [](auto& to) { to.sync_read(56, 2, Bytes{1, 2}); };
  const std::size_t state = host.read(2, 56, 2).size();
  EXPECT_EQ(host.exchange(request).size(), GetParam() == BusKind::kScs ? 0 : state);
  host.write(2, torque, {1});
  host.chain->restart();
  EXPECT_FALSE(host.chain->driven_position(1));
  EXPECT_TRUE(host.ping(2).empty());
  host.pass(1.0);
  EXPECT_EQ(host.ping(2).size(), one);
}

// Packets with any instruction and parameters, and noise between them.
TEST_P(ServoChainTest, NoPacketDoesHarm) {
  Random random(5);
  ServoTalk host = talk(true);
  std::size_t answered = 0;
  for (int i = 0; i < 5000; ++i) {
    std::size_t echo = 0;
    const Bytes sent = host.exchange([&](auto& to) {
      const std::uint8_t ids[] = {1, 2, 3, wire::kEveryone};
      const std::uint8_t common[] = {1, 2, 3, 4, 5, 8, 0x82, 0x83, 0x10};
      to.begin(ids[random.below(4)], common[random.below(9)]);
      for (std::uint64_t left = random.below(20); left > 0; --left) {
        to.put8(random.below(3) == 0 ? testing::random_byte(random)
                                     : static_cast<std::uint8_t>(random.below(5)));
      }
      to.end();
      echo = to.written().size();
    });
    answered += sent.size() > echo ? 1 : 0;
    Bytes noise;
    testing::append_noise(noise, random);
    host.chain->receive(noise);
    for (std::size_t k = 0; k < 2; ++k) {
      const double driven = host.chain->driven_position(k).value_or(0.0);
      ASSERT_LE(driven, is_dynamixel() ? 4095.0 : 65535.0);
      ASSERT_GE(driven, is_dynamixel() ? 0.0 : -65535.0);
    }
    if (random.below(50) == 0) host.chain->restart();
    if (random.below(3) == 0) host.pass(1.0);
  }
  EXPECT_GT(answered, 500u);
}

}  // namespace
}  // namespace somato::emulation
