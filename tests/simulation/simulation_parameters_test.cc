#include "somato/simulation/simulation_parameters.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(SimulationParameters, EveryNumberIsDeclaredAsOurs) {
  for (const auto& parameter : SimulationParameters::declarations().all()) {
    EXPECT_NE(parameter.info.text.find("not given in the paper"), std::string::npos)
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

TEST(SimulationParameters, NegativeNoiseIsRefused) {
  SimulationParameters parameters;
  const auto refused =
      SimulationParameters::declarations().find("placement_noise")->assign(parameters, Value{-1.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
