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

/// Explores objects or materials with a body, simulated or real. A real body has one line, which
/// one thread uses at a time: exploring changes the explorer.
class Explorer {
 public:
  Explorer(const Explorer&) = delete;
  Explorer(Explorer&&) = delete;
  Explorer& operator=(const Explorer&) = delete;
  Explorer& operator=(Explorer&&) = delete;
  virtual ~Explorer() = default;

  const std::vector<ExploredThing>& things() const { return things_; }

  /// Whether its explorations move a real body. These have a person's command as their cause, never
  /// an event such as a page that opens.
  virtual bool moves_real_body() const { return true; }

  /// Whether a fault has stopped a real body. It then does not explore until resume().
  virtual bool is_stopped() const { return false; }

  /// A person lets the body move again after a fault.
  virtual void resume() {}

  /// The labels of an exploration of a thing in a trial, both counting from 0.
  virtual std::vector<Label> labels(std::size_t thing, std::size_t trial) const;

  /// Explores a thing (counting from 0), as trial number `trial` (from 0). Throws InvalidArgument
  /// for an unknown thing. Errors name the thing: failures of the exploration; those of the
  /// observer. There is no exploration then.
  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options = {});

 protected:
  /// `source` is the source of every exploration.
  Explorer(std::vector<ExploredThing> things, std::string source)
      : things_(std::move(things)), source_(std::move(source)) {}

  virtual Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                            const ExploreOptions& options) = 0;

  /// The exploration of a thing with its source, or its error with the name of the thing.
  Result<Exploration> named(std::size_t thing, Result<Exploration> explored) const;

 private:
  std::vector<ExploredThing> things_;
  std::string source_;
};

/// Explores with simulated bodies, a new one for each exploration: several threads can explore at
/// once, and nothing real moves. Code that explores without a person's command, such as in the
/// background, takes this type.
class SimulatedExplorer : public Explorer {
 public:
  bool moves_real_body() const final { return false; }

  /// See Explorer::explore(). The result depends only on the thing, the trial, the placement and
  /// the seed of the simulation.
  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options = {}) const;

 protected:
  using Explorer::Explorer;

  virtual Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                                       const ExploreOptions& options) const = 0;

 private:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) final {
    return simulate(thing, trial, options);
  }
};

/// Prepares a body for an exploration with these options: its limits, and its observer, which
/// receives `scene` and after each step `poses`. `options` must outlive the body's steps. Errors:
/// those of the observer.
Result<void> prepare_body(Body& body, const ExploreOptions& options,
                          const std::function<Scene()>& scene,
                          std::function<std::vector<ScenePose>()> poses);

}  // namespace somato
