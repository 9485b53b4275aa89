#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recordings/tables/name_pattern.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A file with the recording of one trial, and the labels from its name.
struct TrialFile {
  std::string path;
  std::string name;  ///< The path below the folder, with slashes.
  std::vector<Label> labels;
};

/// Whether a regular file, and no folder, is at `path`.
bool is_one_file(const std::filesystem::path& path);

/// The files below `folder` that fit `pattern`, in natural order; `folder` may also be one file,
/// whose name is then the last part of its path. Others with its extension are
/// refused unless `pass_over_others`.
/// Errors: as files_below() and NamePattern::match(); kData for no file at all, a file that does
/// not fit, a name that is not UTF-8, and two files with the same labels.
Result<std::vector<TrialFile>> find_trial_files(const std::filesystem::path& folder,
                                                const NamePattern& pattern, bool pass_over_others);

}  // namespace somato
