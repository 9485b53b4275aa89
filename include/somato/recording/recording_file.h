#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// Whether these first bytes of a file (8 suffice) are those of MCAP.
bool is_mcap(std::string_view bytes);

/// Whether the file at `path` can be read and begins so.
bool is_mcap_file(const std::string& path);

/// Writes `recording` to the file at `path`, wholly or not at all, as save_whole() does, in the
/// layout of docs/formats/recording.md. Reading gives the same recording, if its times are whole
/// nanoseconds and marks of validity that are all 1 are left out.
///
/// Errors: kData for what validate() or RecordingWriter refuses; kSystem with the system's reason.
Result<void> write_recording(const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters = {});

/// Writes a recording an exploration at a time, as write_recording() does: the file takes its
/// place, whole, when it is finished; before, or without that, nothing changes there. Memory does
/// not grow with the recording.
class RecordingFile {
 public:
  /// Errors: kSystem with the system's reason.
  static Result<RecordingFile> begin(const std::string& path,
                                     const RecordingFileParameters& parameters = {});

  RecordingFile(const RecordingFile&) = delete;
  RecordingFile(RecordingFile&& other) noexcept;
  RecordingFile& operator=(const RecordingFile&) = delete;
  RecordingFile& operator=(RecordingFile&& other) noexcept;
  ~RecordingFile();

  /// Errors: kData for what validate() refuses of an exploration by itself and for what
  /// RecordingWriter refuses; kSystem with the system's reason.
  Result<void> add(Exploration exploration);

  /// Errors: kSystem with the system's reason.
  Result<void> finish();

  class State;

 private:
  explicit RecordingFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Reads the whole recording in the MCAP file at `path`; errors as RecordingReader. What it holds
/// is not validated.
Result<Recording> read_recording(const std::string& path);

namespace detail {

/// The same on the given file system, for tests.
Result<void> write_recording(FileSystem& files, const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters);

}  // namespace detail

}  // namespace somato
