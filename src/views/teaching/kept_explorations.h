#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "bodies/body/exploration_draft.h"
#include "recordings/explorations/given_names.h"
#include "recordings/file/growing_recording.h"
#include "somato/bodies/body.h"
#include "somato/bodies/scene.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// The explorations of a view: those that it began with, and those that a body has completed, with
/// the labels that viewers gave them. Used by one thread.
class KeptExplorations {
 public:
  /// The explorations of the body are saved in `file`, if it is not nullptr. Both must outlive
  /// this.
  KeptExplorations(Recording& recording, GrowingRecording* file);

  std::size_t count() const { return recording_.explorations.size(); }

  /// The next exploration begins, with these labels, and takes a step whose readings are recorded:
  /// both are saved at once. Errors: those of the file, once for each exploration.
  void begin_next(const BodyDescription& body, std::vector<Label> labels);
  Result<void> append_to_next(const BodyState& state);

  /// Adds an exploration with its scene, or nullptr. Errors: it is not valid, or unlike the others.
  Result<void> add(Exploration exploration, std::shared_ptr<ScenePlayer> scene);

  /// Saves the exploration that was added last. It is on the disk when this returns. Errors: those
  /// of the file.
  Result<void> save_last();

  /// The scene that was added with an exploration; nullptr without one.
  std::shared_ptr<ScenePlayer> scene(std::size_t index) const { return scenes_[index]; }

  const GivenNames& names() const { return names_; }

  /// Gives a label to an exploration, which may not have ended, and saves it. Errors: kUsage if the
  /// exploration is not in the file; those of the file.
  Result<void> name(std::size_t index, const Label& given);

  /// The next exploration is discarded, and its labels.
  void discard_next();

 private:
  std::optional<std::size_t> number_in_file(std::size_t index) const;

  Recording& recording_;
  GrowingRecording* file_;
  std::optional<ExplorationDraft> draft_;
  GivenNames names_;
  std::vector<std::shared_ptr<ScenePlayer>> scenes_;  // of each, or nullptr
  std::vector<std::optional<std::size_t>> numbers_;   // of each, in the file
};

}  // namespace somato::live
