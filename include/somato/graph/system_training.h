#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/recording.h"

namespace somato {

/// How a system is trained.
struct SystemTraining {
  std::uint64_t seed = 1;
  std::size_t threads = 1;  ///< The result is the same for any number.
  Progress progress = {};   ///< Told draws of all phases; asked to stop at least every 64 of them.
  std::optional<std::size_t> without = {};  ///< A module of parameters_alone() that somebody else
                                            ///< trains; or none.
};

/// Trains a system on `explorations` of a recording and nothing else of it, phase by phase.
///
/// In a phase of a single module that learns at once, that module does so in its own way. Otherwise
/// explorations are drawn at random. Drawn explorations are used as a whole; drawn frames are those
/// of drawn explorations one after the other, the last exploration as far as draws are left (P06
/// section 4.2). With each draw everything is computed with the weights as they are, then all
/// modules of the phase learn. The first learning module of a system has `seed`; every other one,
/// counted in the order of the description, a seed made of it; a phase draws by the seed of its
/// first module.
///
/// `activations` are those of evaluate_fixed(); what is computed of frozen modules on the way is
/// added for `explorations`. Errors: kData and kUsage with their place, kInterrupted.
Result<void> train_system(System& system, const Recording& recording,
                          std::span<const std::size_t> explorations, const SystemTraining& training,
                          Activations& activations);

/// The parameters that train_system() would train a map with, by itself on what comes in once an
/// exploration; nothing for a module that is no map, learns with others or from frames, or that
/// others learn from.
std::optional<SomParameters> parameters_alone(const System& system, std::size_t module,
                                              std::uint64_t seed);

/// Gives the map `module` what was trained elsewhere, with parameters_alone(). Throws
/// InvalidArgument when the module is no map, or one of another size.
void set_map(System& system, std::size_t module, Som som);

}  // namespace somato
