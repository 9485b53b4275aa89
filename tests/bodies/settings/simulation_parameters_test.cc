#include "somato/simulation/simulation_parameters.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(SimulationParameters, EveryNumberIsDeclaredAsNotGivenInThePaper) {
  for (const auto& parameter : SimulationParameters::declarations().all()) {
    if (parameter.info.name == "true_values") continue;  // what is recorded, not what happens
    EXPECT_NE(parameter.info.text.find("ot given in the paper"), std::string::npos)
        << parameter.info.name;
  }
}

TEST(SimulationParameters, DefaultsAreWithinTheirRanges) {
  SimulationParameters defaults;
  for (const auto& parameter : SimulationParameters::declarations().all()) {
    EXPECT_TRUE(parameter.assign(defaults, parameter.read(SimulationParameters{})))
        << parameter.info.name;
  }
}

TEST(SimulationParameters, WhatVariesMayBeTurnedOffAndIsNeverNegative) {
  for (const char* name : {"placement_noise", "placement_turn", "sensor_noise", "joint_noise",
                           "servo_play", "friction"}) {
    SCOPED_TRACE(name);
    SimulationParameters parameters;
    const auto parameter = SimulationParameters::declarations().find(name);
    EXPECT_TRUE(parameter->assign(parameters, Value{0.0}));
    const auto refused = parameter->assign(parameters, Value{-0.001});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  }
}

}  // namespace
}  // namespace somato
