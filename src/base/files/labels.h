#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The labels in `text`, from the source `where`: UTF-8, one per line, without blanks at both ends.
/// Errors (kData): an empty line before the last label, no label, binary content.
Result<std::vector<std::string>> parse_labels(std::string_view text, std::string_view where);

/// The labels in the file at `path`; see parse_labels() and read_whole().
Result<std::vector<std::string>> read_labels(const std::string& path);

/// The same for a table of `rows` rows. Errors: also kData for another number of labels.
Result<std::vector<std::string>> read_labels(const std::string& path, std::size_t rows);

}  // namespace somato
