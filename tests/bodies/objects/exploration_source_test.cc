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
