#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Whether `a` comes before `b` for a person: runs of digits count as numbers, so that trial_2
/// comes before trial_10.
bool naturally_before(std::string_view a, std::string_view b);

/// The paths of all files in `folder` and its subfolders whose names end in `extension`
/// (case-insensitive; empty: all), relative to it, with slashes, in natural order. Folders that are
/// links are followed. Errors: kSystem for a folder that is missing or cannot be read; kData for
/// folders more than 16 deep.
Result<std::vector<std::string>> files_below(const std::filesystem::path& folder,
                                             std::string_view extension);

}  // namespace somato
