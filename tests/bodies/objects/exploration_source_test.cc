#include "bodies/objects/exploration_source.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(ExplorationSource, OfASimulatedBodyStatesItsThings) {
  const auto own = simulated_source("lucs2", "MuJoCo 3", 7, SimulatedThings::kBuiltIn);
  EXPECT_EQ(own, "lucs2, simulated (MuJoCo 3), seed 7");
  EXPECT_TRUE(is_of_built_in_things(own));
  EXPECT_TRUE(is_of_body(own));
  const auto given = simulated_source("lucs2", "MuJoCo 3", 7, SimulatedThings::kGiven);
  EXPECT_EQ(given, own + ", things of another table");
  EXPECT_FALSE(is_of_built_in_things(given));
  EXPECT_TRUE(is_of_body(given));
}

TEST(ExplorationSource, OfPlayedSensorsStatesTheirSeedBeforeTheThings) {
  const auto own = simulated_source("lucs2", "MuJoCo 3", 7, SimulatedThings::kBuiltIn);
  EXPECT_EQ(played_source(own, 9), "lucs2, simulated (MuJoCo 3), seed 7, sensors played, seed 9");
  EXPECT_TRUE(is_of_built_in_things(played_source(own, 9)));
  EXPECT_TRUE(is_of_body(played_source(own, 9)));
  const auto given = simulated_source("lucs2", "MuJoCo 3", 7, SimulatedThings::kGiven);
  EXPECT_EQ(played_source(given, 9), played_source(own, 9) + ", things of another table");
  EXPECT_FALSE(is_of_built_in_things(played_source(given, 9)));
}

TEST(ExplorationSource, OfSensorsPlayedAgainStatesTheLastSeed) {
  for (const auto things : {SimulatedThings::kBuiltIn, SimulatedThings::kGiven}) {
    const auto source = simulated_source("lucs2", "MuJoCo 3", 7, things);
    EXPECT_EQ(played_source(played_source(source, 12), 9), played_source(source, 9));
  }
}

TEST(ExplorationSource, OfADeviceStatesNothingAboutThings) {
  EXPECT_FALSE(is_of_built_in_things(device_source("left hand")));
  EXPECT_TRUE(is_of_body(device_source("left hand")));
}

TEST(ExplorationSource, OfAFileIsNoBody) {
  for (const char* source : {"", "trials/device 7.csv", "topics of ws://robot:8765"}) {
    EXPECT_FALSE(is_of_body(source)) << source;
    EXPECT_FALSE(is_of_built_in_things(source)) << source;
  }
}

}  // namespace
}  // namespace somato
