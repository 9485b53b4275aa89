#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "flags/command_line.h"
#include "recordings/file/growing_recording.h"
#include "somato/core/result.h"
#include "views/session/losses.h"

namespace somato::program {

/// The recording of a body's explorations during a session, if it is saved.
class SessionRecording {
 public:
  /// `path` is empty if nothing is saved.
  SessionRecording(std::string path, Rollover rollover)
      : path_(std::move(path)), rollover_(std::move(rollover)) {}

  /// Begins the file. Errors: those of GrowingRecording.
  Result<void> begin();

  /// The file that grows, or nullptr.
  GrowingRecording* file() { return file_.get(); }

  /// Called after the session is stopped; returns a line about the file, or nothing. Without an
  /// exploration there is no file. Errors: those of GrowingRecording.
  Result<std::string> finish();

  std::size_t explorations() const { return file_ ? file_->count() : 0; }

 private:
  std::string path_;
  Rollover rollover_;
  std::unique_ptr<GrowingRecording> file_;
};

/// The flag `--every`, and when it has the recording go on in another file. Errors (kUsage):
/// neither a time nor an amount of memory; a name of a file without "{time}".
Flag every_flag();
Result<Rollover> read_rollover(const Arguments& arguments);

/// A line about what a session has lost, or nothing.
std::string losses_text(const Losses& losses);

/// "4 explorations saved in hand.mcap".
std::string saved_text(const GrowingRecording& file);

}  // namespace somato::program
