#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/csv_import.h"

namespace somato {

/// The labels that number the explorations of a file, and that hold the file's name.
inline constexpr const char* kWindowLabel = "window";
inline constexpr const char* kRowLabel = "row";
inline constexpr const char* kFileLabel = "file";

/// Whether a file becomes several explorations.
inline bool divides_files(const CsvTrials& trials) {
  return trials.window.has_value() || trials.rows == CsvRows::kExplorations;
}

/// The labels from names of files and from columns, in the order of an exploration. The pattern
/// must have been checked.
std::vector<std::string> csv_label_names(const CsvTrials& trials);

/// Checks that `elements` columns fill the shape of `channel`. Errors (kUsage): they do not.
Result<void> check_csv_shape(const CsvChannel& channel, std::size_t elements);

/// Checks all parts as check_csv_import(); an error's place is what `place` gives for the part that
/// it lies in, 0 for [import] and then the channels.
Result<void> check_csv_parts(const CsvImport& description,
                             const std::function<std::string(std::size_t)>& place);

}  // namespace somato
