#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/bodies/object.h"
#include "somato/bodies/placement.h"
#include "somato/bodies/scene.h"
#include "somato/recording/recording.h"

namespace somato {

/// An object for a hand, or a material for a probe, which has no shape.
struct ExploredThing {
  std::string name;
  std::optional<Object> object;
  Material material;
};

/// One step of an exploring body.
struct ExplorationStep {
  const BodyState& state;
  std::vector<ScenePose> poses;  ///< The poses of the scene's bodies after the step.
  Readings readings = Readings::kLeftOut;
};

/// Observes an exploration. The body waits during each call, for any duration, without effect on
/// its movements and readings. An error ends the exploration with that error.
struct ExplorationObserver {
  /// Called before a body moves; again for the next body if several explore.
  std::function<Result<void>(const BodyDescription& body, const Scene& scene)> on_begin;

  /// Called after each step of the body.
  std::function<Result<void>(const ExplorationStep& step)> on_step;
};

/// Options of an exploration.
struct ExploreOptions {
  BodyLimits limits = {};  ///< For each exploring body.
  std::optional<Placement> placement =
      {};  ///< The placement of an object; drawn at random by default.
  ExplorationObserver observer = {};
};

/// Explores objects or materials with a body, simulated or real; const functions of a simulated one
/// can be used by several threads.
class Explorer {
 public:
  Explorer(const Explorer&) = delete;
  Explorer(Explorer&&) = delete;
  Explorer& operator=(const Explorer&) = delete;
  Explorer& operator=(Explorer&&) = delete;
  virtual ~Explorer() = default;

  const std::vector<ExploredThing>& things() const { return things_; }

  /// The labels of an exploration of a thing in a trial, both counting from 0.
  virtual std::vector<Label> labels(std::size_t thing, std::size_t trial) const;

  /// Explores a thing (counting from 0), as trial number `trial` (from 0). The result of a
  /// simulated body depends only on these, the placement and its seed. Throws InvalidArgument for
  /// an unknown thing. Errors name the thing: failures of the exploration; those of the observer.
  /// There is no exploration then.
  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options = {}) const;

 protected:
  /// `source` is the source of every exploration.
  Explorer(std::vector<ExploredThing> things, std::string source)
      : things_(std::move(things)), source_(std::move(source)) {}

  virtual Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                            const ExploreOptions& options) const = 0;

 private:
  std::vector<ExploredThing> things_;
  std::string source_;
};

/// Prepares a body for an exploration with these options: its limits, and its observer, which
/// receives `scene` and after each step `poses`. `options` must outlive the body's steps. Errors:
/// those of the observer.
Result<void> prepare_body(Body& body, const ExploreOptions& options,
                          const std::function<Scene()>& scene,
                          std::function<std::vector<ScenePose>()> poses);

}  // namespace somato
