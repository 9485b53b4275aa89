#pragma once

#include <filesystem>
#include <string>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads a folder of WAV files, or one file, with one exploration each. Its channel `sound` has an
/// element for each channel of the file and the file's rate; see decode_wav() for the values.
///
/// `files` is a pattern of their names with labels in braces, such as
/// "{material}_{trial:number}.wav", as for import_csv_trials(); other files with its extension are
/// refused unless `pass_over_others`. The path of the file is the source of its exploration.
///
/// Errors: kUsage for a pattern that has no labels or is invalid; those of find_trial_files(),
/// read_whole() and decode_wav(); kData for another number of channels than in the first file.
Result<Recording> import_wav_trials(const std::filesystem::path& folder, const std::string& files,
                                    bool pass_over_others);

}  // namespace somato
