#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "live/view_source.h"
#include "somato/core/result.h"
#include "somato/recording/recording_file.h"

namespace somato::program {

/// The recording of a body's explorations during a session, if it is saved.
class SessionRecording {
 public:
  /// `path` is empty if nothing is saved.
  explicit SessionRecording(std::string path) : path_(std::move(path)) {}

  /// Makes `source` save each exploration; it must not outlive this object.
  Result<void> begin(ViewSource& source);

  /// Called after the session is stopped; returns a line about the file, or nothing. Without an
  /// exploration there is no file.
  Result<std::string> finish();

  std::size_t explorations() const { return explorations_; }

 private:
  std::string path_;
  std::optional<RecordingFile> file_;
  std::size_t explorations_ = 0;
};

}  // namespace somato::program
