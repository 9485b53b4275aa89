#include "bodies/explorers/explorer_setup.h"

#include "somato/core/random.h"
#include "somato/simulation/simulated_hand.h"

namespace somato::detail {

ExplorationDraws ExplorerSetup::draws_of(std::size_t thing, std::size_t trial) const {
  ExplorationDraws draws;
  draws.seed = seed;
  draws.thing = thing;
  draws.trial = trial;
  draws.time_step = parameters.simulation.time_step;
  return draws;
}

Placement ExplorerSetup::placement_of(std::size_t thing, std::size_t trial) const {
  Random random(seed_of(thing, trial, Draws::kPlacement));
  return draw_placement(parameters.simulation, random);
}

}  // namespace somato::detail
