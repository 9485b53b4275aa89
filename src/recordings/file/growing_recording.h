#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "recordings/file/rollover.h"
#include "somato/core/result.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// The recording of a session, which survives the end of its program at any moment: explorations
/// are written to `PATH.partial` while they take place, and synchronized when they end. The
/// complete recording replaces the file at PATH when the session ends; the partial file is removed
/// after that was read back. Otherwise recover_recording() reads it.
///
/// While an exploration takes place, its frames are written as a draft, at most a quarter of a
/// second late. The exploration that is added at its end takes the place of the draft. With a
/// rollover the recording continues in another file from time to time; each is complete. After a
/// system error every call but begin_again() returns an error, and nothing more is written. Used by
/// one thread.
class GrowingRecording {
 public:
  /// Without a partial file if `path` is a pipe or a device, which is written at once. In `path`,
  /// "{time}" is the time at which a file begins; with a rollover it must be there. Errors: kUsage
  /// if the partial file has the data of an earlier session, or another process writes it; kSystem
  /// with the system's reason.
  static Result<std::unique_ptr<GrowingRecording>> begin(const std::string& path,
                                                         Rollover rollover = {});

  /// The same on the given file system, for tests.
  static Result<std::unique_ptr<GrowingRecording>> begin(FileSystem& files, const std::string& path,
                                                         Rollover rollover = {});

  GrowingRecording(const GrowingRecording&) = delete;
  GrowingRecording(GrowingRecording&&) = delete;
  GrowingRecording& operator=(const GrowingRecording&) = delete;
  GrowingRecording& operator=(GrowingRecording&&) = delete;

  /// Without finish() the partial file remains, if it has an exploration or a draft.
  ~GrowingRecording();

  /// The path of the present file.
  const std::string& path() const { return path_; }

  /// The number of explorations that were added, to all files.
  std::size_t count() const { return before_ + added_.size(); }

  /// The number of files that have explorations.
  std::size_t files() const { return files_before_ + (added_.empty() ? 0 : 1); }

  /// After a system error: begins another file if one is due. Returns whether it has. Explorations
  /// in the partial file of before are left there, to be recovered. Errors as begin().
  Result<bool> begin_again();

  /// Begins the draft of the next exploration, in another file if one is due; one that is open is
  /// dropped. Errors as RecordingWriter.
  Result<void> begin_draft(const ExplorationStart& start);

  /// Adds a frame to the draft. Throws and errors as RecordingWriter.
  Result<void> draft_frame(std::size_t channel, std::span<const float> values, double time);

  /// The draft is complete, and becomes the exploration that add() would add in its place. It is on
  /// the disk when this returns, together with all labels so far. Errors: kUsage without a draft,
  /// as where a pipe is written; kSystem with the system's reason.
  Result<void> keep_draft();

  /// The exploration of the draft, if there is one, does not belong to the recording.
  Result<void> drop_draft();

  /// Adds a complete exploration, in place of the draft. It is on the disk when this returns,
  /// together with all labels so far. Errors: kData for an exploration that validate() refuses;
  /// kSystem with the system's reason.
  Result<void> add(Exploration exploration);

  /// Gives a label to the exploration of that number, of those that were added; that of the draft
  /// has the number count(), which is kept until it is added. It is on the disk when this returns,
  /// together with the frames of a draft so far. Errors: kUsage if it is in a file that is
  /// complete; those of RecordingWriter.
  Result<void> name(std::size_t exploration, const Label& label);

  /// Completes the recording; nothing follows. Without an exploration nothing changes at the path.
  /// Errors: kSystem with the system's reason, and the command that recovers the partial file.
  Result<void> finish();

 private:
  GrowingRecording(FileSystem& files, std::string path, Rollover rollover)
      : files_(&files), pattern_(std::move(path)), rollover_(std::move(rollover)) {}

  std::string free_path() const;
  Result<void> open();
  Result<void> open_partial();
  bool is_due() const { return rollover_.is_due(begun_, bytes_); }
  Result<void> roll();
  void leave_file();
  Result<void> add_valid(Exploration exploration);
  Result<void> add_to_partial(const Exploration& exploration);
  Result<void> label_next(std::uint64_t index);
  Result<void> label_at_once(std::uint64_t index, const Label& label);
  Result<void> end_open();
  Result<void> copy() const;
  Result<void> check_copy() const;
  Result<void> remove_partial();
  Result<void> with_advice(Result<void> done) const;

  FileSystem* files_;
  std::string pattern_;
  Rollover rollover_;
  std::string path_;
  double begun_ = 0.0;      // the present file
  std::size_t bytes_ = 0;   // of frames in it
  std::size_t before_ = 0;  // explorations in the files before
  std::size_t files_before_ = 0;
  std::optional<Error> problem_;         // There is no file.
  std::optional<RecordingFile> direct_;  // A pipe or a device.
  std::optional<RecordingWriter> partial_;
  std::vector<std::uint64_t> added_;    // Their numbers in the partial file, with drafts.
  std::optional<std::uint64_t> draft_;  // The number of the draft.
  std::vector<Label> next_labels_;      // The exploration that is added next has them.
};

}  // namespace somato
