#include "bodies/explorers/explorer_setup.h"

#include "somato/core/random.h"
#include "somato/simulation/simulated_hand.h"

namespace somato::detail {

std::uint64_t ExplorerSetup::seed_of(std::size_t thing, std::size_t trial, Draws draws) const {
  constexpr std::uint32_t kExploring = 0x6578706c;  // apart from other uses of the generator
  const auto words =
      philox4x32({static_cast<std::uint32_t>(thing), static_cast<std::uint32_t>(trial),
                  static_cast<std::uint32_t>(draws), kExploring},
                 {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return (static_cast<std::uint64_t>(words[1]) << 32) | words[0];
}

Placement ExplorerSetup::placement_of(std::size_t thing, std::size_t trial) const {
  Random random(seed_of(thing, trial, Draws::kPlacement));
  return draw_placement(parameters.simulation, random);
}

}  // namespace somato::detail
