#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "recordings/file/growing_recording.h"
#include "somato/core/result.h"

namespace somato::program {

/// The recording of a body's explorations during a session, if it is saved.
class SessionRecording {
 public:
  /// `path` is empty if nothing is saved.
  explicit SessionRecording(std::string path) : path_(std::move(path)) {}

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
  std::unique_ptr<GrowingRecording> file_;
};

/// "4 explorations saved in hand.mcap".
std::string saved_text(const GrowingRecording& file);

}  // namespace somato::program
