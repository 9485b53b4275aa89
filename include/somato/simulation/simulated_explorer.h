#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/explorer.h"
#include "somato/bodies/object_table.h"
#include "somato/core/parameter.h"
#include "somato/core/value.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// The physics engine of the simulated bodies, with its version, such as "MuJoCo 3.17.0". Forces
/// and poses of a simulation depend on it.
std::string physics_engine();

/// The exploring body.
enum class ExploringBody {
  kLucs2,      ///< LUCS Haptic Hand II grasps an object from several poses.
  kLucs3,      ///< LUCS Haptic Hand III closes on an object once.
  kTexture,    ///< The texture probe strokes a material.
  kHardness,   ///< The hardness probe presses a material.
  kProbes,     ///< Both probes explore a material in the same exploration.
  kAllSenses,  ///< Hand III with taxels closes on an object; both probes explore its material.
};

template <>
struct Choices<ExploringBody> {
  static const std::vector<std::pair<ExploringBody, std::string>>& all();
};

/// Whether only probes explore, which have no simulated hand.
bool is_probe(ExploringBody body);

/// The things of a body's default table: Table I for Hand II, Somato's own for Hand III and all
/// senses, the eight materials for the probes.
Result<ObjectTable> default_things(ExploringBody body);

/// Whether all `given` parameters of the simulation have an effect on the body. Errors (kUsage):
/// the first that has none, at its location.
Result<void> check_effect(ExploringBody body, const Table& given);

class GraspPictures;

/// Explores in simulation, with the labels object, shape, girth, material, hardness and trial; for
/// a probe material, hardness and trial. A hand explores the table's objects; a probe its
/// materials, or if it has none, those of its objects. Pictures of grasps are passed to `pictures`,
/// which must outlive the explorer, or is nullptr.
///
/// Checks that every thing fits before any movement. Errors: kUsage for a table without such things
/// and for objects that do not fit the hand; those of HandScene::build() and of the probes.
Result<std::unique_ptr<SimulatedExplorer>> simulated_explorer(ExploringBody body,
                                                              const ObjectTable& things,
                                                              const ExploringParameters& parameters,
                                                              std::uint64_t seed,
                                                              GraspPictures* pictures = nullptr);

}  // namespace somato
