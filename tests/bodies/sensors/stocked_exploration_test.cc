#include "bodies/sensors/stocked_exploration.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bodies/support/things.h"
#include "somato/simulation/sense.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

constexpr std::uint64_t kStockedSeed = 5;

Object stocked_tube(const std::string& name, double diameter) {
  Object tube = cylinder_thing();
  tube.name = name;
  tube.size = {diameter, diameter, 140.0};
  tube.material = declared_materials().front();
  return tube;
}

// Movements without chance, so that only the noise of the potentiometers depends on the number.
ExploringParameters without_chance() {
  ExploringParameters parameters;
  parameters.simulation.placement_noise = 0.0;
  parameters.simulation.servo_play = 0.0;
  parameters.simulation.joint_spread = 2.0;
  parameters.simulation.true_values = true;
  return parameters;
}

Exploration grasp(const std::vector<Object>& objects, std::size_t thing) {
  const auto explorer = simulated_explorer(ExploringBody::kLucs3, ObjectTable{objects, {}},
                                           without_chance(), kStockedSeed);
  EXPECT_TRUE(explorer) << to_string(explorer.error());
  return (*explorer)->explore(thing, 1).value();
}

TEST(StockedExploration, HasTheLabelsAndTheNoiseOfAnExplorationOfTheTable) {
  const Object narrow = stocked_tube("narrow", 45.0);
  const Object wide = stocked_tube("wide", 70.0);
  const Exploration of_table = grasp({narrow, wide}, 1);
  const Exploration of_stock = grasp({stocked_tube("object", 70.0)}, 0);
  EXPECT_NE(of_stock.channels, of_table.channels) << "the number decides the noise";
  const Exploration named = as_thing(of_stock, wide, 1).value();
  EXPECT_EQ(named.labels, of_table.labels);
  EXPECT_EQ(sense(named, without_chance()).value().channels, of_table.channels);
}

TEST(StockedExploration, RequiresTrueValues) {
  Exploration without = grasp({stocked_tube("object", 70.0)}, 0);
  std::erase_if(without.channels, [](const Channel& one) { return one.name == "true_draws"; });
  const auto refused = as_thing(without, stocked_tube("tube", 70.0), 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
