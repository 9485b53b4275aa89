#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "somato/recording/recording.h"

namespace somato::detail {

/// Random quantities of an exploration.
enum class Draws : std::uint32_t { kPlacement, kHand, kTexture, kHardness };

/// The seed of these draws in one exploration; far apart from all others.
std::uint64_t draws_seed(std::uint64_t seed, std::uint64_t thing, std::uint64_t trial, Draws draws);

/// The numbers on which the noise of the sensors in an exploration depends, besides their
/// settings.
struct ExplorationDraws {
  std::uint64_t seed = 0;          ///< Seed of the simulation.
  std::uint64_t thing = 0;         ///< Index in the table of things that were explored.
  std::uint64_t trial = 0;         ///< From 0.
  std::uint64_t sound_before = 0;  ///< Frames of the sound before the first that is recorded.
  std::uint64_t stick_before = 0;  ///< Ticks of the hardness probe up to the reading.
  double time_step = 0.0;          ///< Seconds of a step of a hand's physics.

  std::uint64_t seed_of(Draws draws) const { return draws_seed(seed, thing, trial, draws); }
};

/// The draws in the channel `true_draws`; empty if the exploration has none. Errors (kData): the
/// channel is not as put_draws() writes it.
Result<std::optional<ExplorationDraws>> draws_of(const Exploration& exploration);

/// Adds the channel `true_draws`, or replaces it.
void put_draws(const ExplorationDraws& draws, Exploration& exploration);

}  // namespace somato::detail
