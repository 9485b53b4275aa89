#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "somato/bodies/placement.h"
#include "somato/simulation/simulated_explorer.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// Random quantities of an exploration.
enum class Draws : std::uint32_t { kPlacement, kHand, kTexture, kHardness };

/// Settings of all simulated explorers.
struct ExplorerSetup {
  ExploringParameters parameters;
  std::uint64_t seed = 1;
  std::string source;                 ///< The source of each exploration.
  GraspPictures* pictures = nullptr;  ///< Destination of pictures of grasps, or nullptr.

  /// The seed of these draws in one exploration; far apart from all others.
  std::uint64_t seed_of(std::size_t thing, std::size_t trial, Draws draws) const;

  /// The placement of an object before a hand, drawn with that seed.
  Placement placement_of(std::size_t thing, std::size_t trial) const;
};

}  // namespace somato::detail
