#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// What became of a damaged file.
struct RecoveryReport {
  std::uint64_t messages = 0;      ///< That were saved, without those of /exploration.
  std::uint64_t explorations = 0;  ///< That were saved, with the incomplete ones.
  std::uint64_t incomplete = 0;    ///< Whose beginning, end or frames are missing.
  std::vector<Error> damage;       ///< The first places of it, with what is wrong there.
  std::uint64_t damaged_places = 0;
  bool lossless = true;  ///< Whether all messages were saved; damage behind them costs nothing.
};

/// Saves what the MCAP file `from` holds: everything that is complete goes to the file `to`, which
/// is whole then. An exploration without an end is ended with its last frame. From a chunk that is
/// not packed and cut off, its complete messages are saved; from the others all or nothing. Memory
/// does not grow with the file.
///
/// Errors: kData when nothing can be saved (`to` is left as it was), or for no MCAP file; kSystem
/// with the system's reason; kUsage for what is no regular file.
Result<RecoveryReport> recover_recording(const std::string& from, const std::string& to,
                                         const RecordingFileParameters& parameters = {});

namespace detail {

/// The same on the given file system, for tests.
Result<RecoveryReport> recover_recording(FileSystem& files, const std::string& from,
                                         const std::string& to,
                                         const RecordingFileParameters& parameters);

}  // namespace detail

}  // namespace somato
