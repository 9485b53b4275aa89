#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recording/name_pattern.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A file with the recording of one trial, and the labels that its name tells.
struct TrialFile {
  std::string path;
  std::vector<Label> labels;
};

/// The files below `folder` that fit `pattern`, in natural order. Others with its extension are
/// refused unless `pass_over_others`.
/// Errors: as files_below() and NamePattern::match(); kData for no file at all, a file that does
/// not fit, a name that is not UTF-8, and two files with the same labels.
Result<std::vector<TrialFile>> find_trial_files(const std::filesystem::path& folder,
                                                const NamePattern& pattern, bool pass_over_others);

}  // namespace somato
