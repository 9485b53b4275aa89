#pragma once

#include <filesystem>
#include <string>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads a folder of recordings (MCAP), with one or more explorations each, into one recording.
///
/// `files` is a pattern of their names with labels in braces, such as
/// "{object}_{trial:number}.mcap", as for import_csv_trials(); other files with its extension are
/// refused unless `pass_over_others`. The explorations are in natural order of files; each has its
/// own labels followed by those of the file name, and, if it has no source, the path of the file as
/// source.
///
/// Errors: kUsage for a pattern that has no labels or is invalid; those of read_recording(); kData
/// with the file for names as in import_csv_trials(), a file without explorations, a label with one
/// value in the recording and another in the name, and other channels or labels than in the first
/// exploration.
Result<Recording> import_mcap_trials(const std::filesystem::path& folder, const std::string& files,
                                     bool pass_over_others);

}  // namespace somato
