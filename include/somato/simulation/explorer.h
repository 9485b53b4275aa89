#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/bodies/object_table.h"
#include "somato/core/parameter.h"
#include "somato/recording/recording.h"
#include "somato/simulation/exploring_parameters.h"

namespace somato {

/// What explores.
enum class ExploringBody {
  kLucs2,      ///< LUCS Haptic Hand II grasps an object from several poses.
  kLucs3,      ///< LUCS Haptic Hand III closes on an object once.
  kTexture,    ///< The texture probe strokes a material.
  kHardness,   ///< The hardness probe presses a material.
  kProbes,     ///< Both probes try a material in the same exploration.
  kAllSenses,  ///< Hand III with taxels closes on an object; both probes try what it is made of.
};

template <>
struct Choices<ExploringBody> {
  static const std::vector<std::pair<ExploringBody, std::string>>& all();
};

/// The things of a body's own table: Table I for Hand II, Somato's for Hand III and all senses, the
/// eight materials for the probes.
Result<ObjectTable> default_things(ExploringBody body);

class GraspPictures;

/// What accompanies an exploration.
struct ExploreOptions {
  BodyLimits limits;                  ///< Of each body that explores.
  GraspPictures* pictures = nullptr;  ///< Where the grasps of a hand are drawn, or nowhere.
};

/// Explores things in simulation; constant, so that threads may share it.
class Explorer {
 public:
  /// Gets ready, and checks before anything moves that every thing fits. A hand explores the
  /// table's objects; a probe its materials, or where it has none those of its objects. Errors:
  /// kUsage for a table without such things and for objects that do not fit the hand; those of
  /// HandScene::build() and of the probes.
  static Result<Explorer> build(ExploringBody body, const ObjectTable& things,
                                const ExploringParameters& parameters, std::uint64_t seed);

  /// The names of the things, in the table's order.
  const std::vector<std::string>& things() const;

  /// Explores a thing (counting from 0) for its so-and-so-manieth time (from 0), with the labels
  /// object, shape, girth, material, hardness and trial; for a probe material, hardness and trial.
  /// Depends on its arguments and the seed alone.
  /// Errors: what went wrong with it, naming the thing; it is then no exploration.
  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options = {}) const;

 private:
  class Parts;
  explicit Explorer(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
  std::shared_ptr<const Parts> parts_;
};

}  // namespace somato
