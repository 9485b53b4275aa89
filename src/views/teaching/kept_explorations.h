#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bodies/body/exploration_draft.h"
#include "recordings/explorations/given_names.h"
#include "recordings/file/growing_recording.h"
#include "somato/bodies/body.h"
#include "somato/bodies/scene.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "views/replay/kept_scene.h"
#include "views/session/view_source.h"
#include "views/teaching/name_counts.h"

namespace somato::live {

/// The explorations of a view: those that it began with, and those that a body has completed, with
/// the labels that viewers gave them. Each has an index, counting from 0; the oldest ones make room
/// for new ones. Used by one thread.
class KeptExplorations {
 public:
  /// The explorations of the body are added to the recording of the source and saved in its file,
  /// if it has one. `source` must outlive this.
  explicit KeptExplorations(ViewSource& source);

  /// The number of explorations so far. Those from first() on are kept.
  std::size_t count() const { return first() + source_.recording.explorations.size(); }
  std::size_t first() const { return source_.first; }

  /// A kept exploration, by its index.
  const Exploration& operator[](std::size_t index) const {
    return source_.recording.explorations[index - first()];
  }

  /// Identifies an exploration that is kept, or the next one. Another exploration never has
  /// the same number, while the index of one that is discarded is used again.
  std::size_t id(std::size_t index) const { return index < count() ? at(index).id : next_id_; }

  /// The index of that exploration. Errors (kUsage): it was discarded, is no longer kept, or has
  /// not begun.
  Result<std::size_t> index_of(std::size_t id) const;

  /// The next exploration begins, with these labels, and takes a step whose readings are recorded:
  /// both are saved at once. Errors: those of the file. After a system error nothing more is saved,
  /// without a further error, until another file is due and can be begun.
  void begin_next(const BodyDescription& body, std::vector<Label> labels);
  Result<void> append_to_next(const BodyState& state);

  /// Adds an exploration with its scene, or nullptr. Errors: it is not valid, or unlike the others.
  Result<void> add(Exploration exploration, std::shared_ptr<KeptScene> scene);

  /// Saves the exploration that was added last. It is on the disk when this returns. Errors: those
  /// of the file; see begin_next().
  Result<void> save_last();

  /// An exploration has ended whose frames are not kept, after drop_before(count()); its draft
  /// becomes a part of the file. Errors: those of the file.
  Result<void> add_unkept();

  /// The first of the latest explorations of which those of the body take no more than `most` bytes
  /// together, with their scenes; the last one in any case.
  std::size_t first_within(std::size_t most) const;

  /// The explorations before `first` are no longer kept.
  void drop_before(std::size_t first);

  /// The scene that was added with an exploration; nullptr without one.
  std::shared_ptr<ScenePlayer> scene(std::size_t index) const { return at(index).scene; }

  /// The number of explorations that could not be saved.
  std::size_t unsaved() const { return unsaved_; }

  const GivenNames& names() const { return names_; }

  /// Gives a label to an exploration, which may not have ended, and saves it. Errors: kUsage if the
  /// exploration is not in the file; kSystem if it has the label, but the file does not.
  Result<void> name(std::size_t index, const Label& given);

  /// Takes back the label that was given last, which exists, also in the file. Errors as name().
  Result<void> take_back_name();

  /// Whether a name that is given now is in the file of the session: it has one, which did not
  /// fail.
  bool saves() const { return saves_; }

  /// The names of all explorations so far, and of the next one if it was given one.
  const NameCounts& counts() const { return counts_; }
  void plan(std::size_t each) { counts_.plan(each); }

  /// The next exploration is discarded, and its labels.
  void discard_next();

 private:
  // An exploration without its frames.
  struct Kept {
    std::size_t id = 0;
    std::shared_ptr<KeptScene> scene;           // or nullptr
    std::optional<std::size_t> number_in_file;  // if it is there
    std::size_t bytes = 0;
  };

  const Kept& at(std::size_t index) const { return kept_[index - first()]; }
  Result<void> checked(Result<void> saved);
  Result<void> count_saved(Result<void> saved);
  Result<void> name_in_file(std::size_t index, const Label& given);
  void count_own(std::size_t index, const std::vector<Label>& labels);
  std::string own_value(std::size_t index, const std::string& label) const;
  std::string counted_value(std::size_t index, const std::string& label) const;
  template <typename Change>
  void recount(std::size_t index, const std::string& label, const Change& change);

  ViewSource& source_;
  std::optional<ExplorationDraft> draft_;
  bool saves_ = false;  // until the file fails
  std::size_t unsaved_ = 0;
  GivenNames names_;
  NameCounts counts_;
  std::vector<Label> next_labels_;  // of the next exploration, without given ones
  std::deque<Kept> kept_;
  std::size_t next_id_ = 0;
  std::size_t bytes_ = 0;  // of those that the body made
};

}  // namespace somato::live
