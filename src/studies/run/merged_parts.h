#pragma once

#include <cstddef>
#include <filesystem>

#include "somato/core/result.h"

namespace somato {

/// The content of a folder of parts.
struct MergedParts {
  std::size_t parts = 0;      ///< Folders of parts.
  std::size_t trainings = 0;  ///< Completed trainings in journals.
  std::size_t studies = 0;    ///< Completed studies of sweeps.
};

/// Whether the folder `from` contains a part with results, complete or not.
bool contains_parts(const std::filesystem::path& from);

/// Adds the results of the parts in the folder `from` to those in `to`, which must exist: journals
/// of studies and completed studies of sweeps, for parts that did not share a folder. Lines that
/// are truncated or damaged are left out, and no line is added twice. Returns what `from` contains.
/// Errors: kSystem; kData if both contain different results of the same name.
Result<MergedParts> merge_parts(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace somato
