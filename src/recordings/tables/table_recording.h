#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"

namespace somato {

/// The table of numbers in the file at `path` as a recording; see load_recording(). Errors: those
/// of read_numbers(); kData for a format.
Result<Recording> read_table_recording(const std::string& path,
                                       const RecordingParameters& parameters);

/// Fails (kUsage) if a setting is given that has an effect on tables only.
Result<void> check_without_table(const RecordingParameters& parameters, const std::string& where);

}  // namespace somato
