#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "live/given_names.h"
#include "somato/bodies/exploring.h"
#include "somato/bodies/scene.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// The explorations of a view: those that it began with, and those that a body has completed, with
/// the labels that viewers gave them. Used by one thread.
class KeptExplorations {
 public:
  /// `sink` takes each exploration of the body, to save it; it may be empty. Both must outlive
  /// this.
  KeptExplorations(Recording& recording, const ExplorationSink& sink);

  std::size_t count() const { return recording_.explorations.size(); }

  /// Adds an exploration with its scene, or nullptr. Errors: it is not valid, or unlike the others.
  Result<void> add(Exploration exploration, std::shared_ptr<ScenePlayer> scene);

  /// The scene that was added with an exploration; nullptr without one.
  std::shared_ptr<ScenePlayer> scene(std::size_t index) const { return scenes_[index]; }

  /// Saves those before `end` that are not saved yet. Errors: those of the sink.
  Result<void> save_before(std::size_t end);

  const GivenNames& names() const { return names_; }

  /// Gives a label to an exploration, which may not have ended. Errors (kUsage): it is saved.
  Result<void> name(std::size_t index, const Label& given);

  /// The next exploration is discarded, and its labels.
  void discard_next() { names_.forget(count()); }

 private:
  Recording& recording_;
  const ExplorationSink& sink_;
  GivenNames names_;
  std::vector<std::shared_ptr<ScenePlayer>> scenes_;  // of each, or nullptr
  std::size_t saved_;  // passed to the sink, and those that the view began with
};

}  // namespace somato::live
