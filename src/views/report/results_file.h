#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/studies/results.h"

namespace somato {

/// Reads the text of a results.json, from the file `path`. The content is fully validated. Errors
/// (kData, with the field): invalid JSON, another version, another kind of file, fields that are
/// missing, of another type or out of range, lists with inconsistent lengths.
Result<Results> parse_results(std::string_view text, const std::string& path);

}  // namespace somato
