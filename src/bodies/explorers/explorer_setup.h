#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "bodies/sensors/exploration_draws.h"
#include "somato/bodies/placement.h"
#include "somato/simulation/simulated_explorer.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// Settings of all simulated explorers.
struct ExplorerSetup {
  ExploringParameters parameters;
  std::uint64_t seed = 1;
  std::string source;                 ///< The source of each exploration.
  GraspPictures* pictures = nullptr;  ///< Destination of pictures of grasps, or nullptr.

  /// See draws_seed().
  std::uint64_t seed_of(std::size_t thing, std::size_t trial, Draws draws) const {
    return draws_seed(seed, thing, trial, draws);
  }

  /// The numbers on which the noise in one exploration depends.
  ExplorationDraws draws_of(std::size_t thing, std::size_t trial) const;

  bool keeps_true_values() const { return parameters.simulation.true_values; }

  /// The placement of an object before a hand, drawn with that seed.
  Placement placement_of(std::size_t thing, std::size_t trial) const;
};

}  // namespace somato::detail
