#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/bodies/object.h"
#include "somato/bodies/placement.h"
#include "somato/bodies/scene.h"
#include "somato/recording/recording.h"

namespace somato {

/// Looks on while a body explores. It may take its time: the body waits, and what it does and feels
/// is the same. An error ends the exploration with that error.
class ExplorationWatcher {
 public:
  ExplorationWatcher() = default;
  ExplorationWatcher(const ExplorationWatcher&) = delete;
  ExplorationWatcher(ExplorationWatcher&&) = delete;
  ExplorationWatcher& operator=(const ExplorationWatcher&) = delete;
  ExplorationWatcher& operator=(ExplorationWatcher&&) = delete;
  virtual ~ExplorationWatcher() = default;

  /// Before anything moves.
  virtual void begins(const BodyDescription& body, const Scene& scene) = 0;

  /// After each step: where everything is, a pose for each body of the scene.
  virtual Result<void> moved(const BodyState& state, const std::vector<ScenePose>& poses) = 0;

  /// After each step whose readings belong to the exploration, after moved().
  virtual Result<void> felt(const BodyState& state) = 0;
};

/// A thing to explore, as far as it is to be shown: a probe's materials have no shape.
struct ShownThing {
  std::string name;
  std::optional<Object> object;
  Material material;
};

/// What is to be explored.
struct WatchedExploration {
  std::size_t thing = 0;
  std::size_t trial = 0;  ///< Counting from 0; what is drawn at random depends on it.
  Placement placement;    ///< Of an object before a hand.
};

/// A body that explores before everybody's eyes.
class WatchedBody {
 public:
  WatchedBody() = default;
  WatchedBody(const WatchedBody&) = delete;
  WatchedBody(WatchedBody&&) = delete;
  WatchedBody& operator=(const WatchedBody&) = delete;
  WatchedBody& operator=(WatchedBody&&) = delete;
  virtual ~WatchedBody() = default;

  virtual const std::string& name() const = 0;
  virtual const std::vector<ShownThing>& things() const = 0;

  /// Whether the placement of a thing means anything.
  virtual bool takes_placement() const = 0;

  /// Explores, with labels as a recording has them. Depends on `what` alone. Errors: what went
  /// wrong in the world, and those of the watcher.
  virtual Result<Exploration> explore(const WatchedExploration& what,
                                      ExplorationWatcher& watcher) const = 0;
};

}  // namespace somato
