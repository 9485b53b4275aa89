#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// The result of recovering a damaged file.
struct RecoveryReport {
  std::uint64_t messages = 0;      ///< Messages that were saved, without those of /exploration.
  std::uint64_t explorations = 0;  ///< Explorations that were saved, including incomplete ones.
  std::uint64_t incomplete = 0;    ///< Explorations without their beginning, end or some frames.
  std::vector<Error> damage;       ///< The first damaged positions, with descriptions.
  std::uint64_t damaged_places = 0;
  bool lossless = true;  ///< Whether all messages were saved; damage after them has no effect.
};

/// Recovers the MCAP file `from`: all complete messages are saved to the file `to`, which is then
/// complete. An exploration without an end is ended with its last frame. From a truncated
/// uncompressed chunk, its complete messages are saved; other chunks are saved completely or not at
/// all. Memory does not grow with the file.
///
/// Errors: kData if nothing can be saved (`to` is unchanged), or for a file that is not MCAP;
/// kSystem with the system's reason; kUsage for a file that is not regular.
Result<RecoveryReport> recover_recording(const std::string& from, const std::string& to,
                                         const RecordingFileParameters& parameters = {});

namespace detail {

/// The same on the given file system, for tests.
Result<RecoveryReport> recover_recording(FileSystem& files, const std::string& from,
                                         const std::string& to,
                                         const RecordingFileParameters& parameters);

}  // namespace detail

}  // namespace somato
