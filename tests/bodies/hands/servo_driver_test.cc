#include "bodies/hands/servo_driver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace somato::detail {
namespace {

// Two servos: pace 2 and 0.5 rad/s, resolution 0.01 and 0.001 rad, play 0 and 0.02 rad.
std::shared_ptr<mjModel> two_servos() {
  auto model = compile_model(
      R"(<mujoco><compiler angle="radian"/><option timestep="0.001"/><size nuser_actuator="3"/>
      <worldbody><body><joint name="a" axis="0 1 0"/><geom size="0.01"/>
      <body><joint name="b" axis="0 1 0"/><geom size="0.01"/></body></body></worldbody>
      <actuator>
      <position joint="a" ctrllimited="true" ctrlrange="-1 1" user="2 0.01 0"/>
      <position joint="b" ctrllimited="true" ctrlrange="-1 1" user="0.5 0.001 0.02"/>
      </actuator></mujoco>)",
      "servos");
  EXPECT_TRUE(model) << model.error().what;
  return *model;
}

const std::array<double, 2> kZero{0.0, 0.0};

TEST(ServoDriver, GoesAtItsPaceAndStopsAtItsTarget) {
  const auto model = two_servos();
  ServoDriver driver(*model, kZero, 0.0, Random(1));
  driver.set_targets(std::array{0.5, -0.5});
  std::array<mjtNum, 2> commands{};
  for (int step = 1; step <= 1200; ++step) {
    driver.step(*model, commands);
    EXPECT_NEAR(driver.positions()[0], std::min(0.5, 0.002 * step), 1e-12);
    EXPECT_NEAR(driver.positions()[1], std::max(-0.5, -0.0005 * step), 1e-12);
  }
  EXPECT_EQ(driver.positions(), (std::vector<double>{0.5, -0.5}));
}

TEST(ServoDriver, CommandsAreWholePulsesNearThePosition) {
  const auto model = two_servos();
  ServoDriver driver(*model, kZero, 0.0, Random(1));
  driver.set_targets(std::array{0.3, 0.3});
  std::array<mjtNum, 2> commands{};
  std::set<double> pulses;
  for (int step = 0; step < 200; ++step) {
    driver.step(*model, commands);
    EXPECT_NEAR(commands[0] / 0.01, std::round(commands[0] / 0.01), 1e-9);
    EXPECT_LE(std::abs(commands[0] - driver.positions()[0]), 0.005 + 1e-12);
    EXPECT_LE(std::abs(commands[1] - driver.positions()[1]), 0.0005 + 1e-12);
    pulses.insert(commands[0]);
  }
  EXPECT_EQ(pulses.size(), 31U);  // 0, 0.01 .. 0.3
}

TEST(ServoDriver, PlayChangesWhenAServoTurnsRoundAndOnlyThen) {
  const auto model = two_servos();
  ServoDriver driver(*model, kZero, 1.0, Random(3));
  std::array<mjtNum, 2> commands{};
  std::vector<double> offsets;
  for (int turn = 0; turn < 2000; ++turn) {
    for (const double share : {0.5, 1.0}) {
      const double target =
          (turn % 2 == 0 ? 0.004 : 0.0) + (turn % 2 == 0 ? 1 : -1) * share * 0.002;
      driver.set_targets(std::array{0.0, target});
      for (int step = 0; step < 20; ++step) driver.step(*model, commands);
      const double offset = commands[1] - driver.positions()[1];
      if (share == 0.5) {
        offsets.push_back(offset);
      } else {
        EXPECT_NEAR(offset, offsets.back(), 1e-12);
      }
    }
    EXPECT_EQ(commands[0], 0.0);
  }
  double squares = 0.0;
  for (const double offset : offsets) squares += offset * offset;
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(offsets.size())), 0.02, 0.001);
}

TEST(ServoDriver, PlayNeverCommandsBeyondTheServosRange) {
  const auto model = two_servos();
  std::array<mjtNum, 2> commands{};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    ServoDriver driver(*model, std::array{0.99, 0.99}, 10.0, Random(seed));
    driver.set_targets(std::array{1.0, 1.0});
    for (int step = 0; step < 30; ++step) driver.step(*model, commands);
    EXPECT_LE(commands[0], 1.0);
    EXPECT_LE(commands[1], 1.0);
  }
}

}  // namespace
}  // namespace somato::detail
