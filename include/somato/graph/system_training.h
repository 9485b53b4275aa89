#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/som_training.h"
#include "somato/recording/recording.h"

namespace somato {

/// Receives the snapshots (see TrainingObserver) of each map that learns separately, from one value
/// per exploration; returning false ends the training.
using SystemObserver = std::function<bool(std::size_t module, const TrainingMoment&)>;

/// Options for training a system.
struct SystemTraining {
  std::uint64_t seed = 1;
  std::size_t threads = 1;  ///< Does not affect the result.
  Progress progress = {};   ///< In draws of all phases; called at least every 64 draws.
  SystemObserver observer = {};

  /// Explorations on which the system will be evaluated. Nothing is learned from them, but a map
  /// trained by inner products then stores those of these explorations as well, and can be
  /// evaluated without weights (Som::knows(), Activations::values_of()).
  std::span<const std::size_t> tested = {};

  /// The class of each exploration of the recording, for maps that learn names and for maps with a
  /// refinement (RefinementParameters), which fail with kUsage without; empty: none.
  std::span<const std::size_t> classes = {};
};

/// Trains a system on `explorations` of a recording only, phase by phase.
///
/// In a phase with a single module that learns at once, the module's own method is used. Otherwise
/// explorations are drawn at random. Drawn explorations are used as a whole; drawn frames are those
/// of drawn explorations in order, the last exploration as far as draws remain (P06 section 4.2).
/// With each draw all outputs are computed with the current weights, then all modules of the phase
/// learn. The first learning module of a system has `seed`; every other one, counted in the order
/// of the description, a seed derived from it; a phase draws with the seed of its first module.
///
/// `activations` are those of evaluate_fixed(); outputs of frozen modules that are computed are
/// added for `explorations`, and inputs of maps for `tested` ones. Errors: kData and kUsage with
/// their location, kInterrupted.
Result<void> train_system(System& system, const Recording& recording,
                          std::span<const std::size_t> explorations, const SystemTraining& training,
                          Activations& activations);

}  // namespace somato
