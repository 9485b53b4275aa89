#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Whether `column` is a pattern of names: it holds a star.
bool is_column_pattern(std::string_view column);

/// Whether `name` matches `pattern`, whose stars match any text, including none.
bool fits_column_pattern(std::string_view pattern, std::string_view name);

/// The columns of a list of names and ranges: "a", "b1..b3" are a, b1, b2, b3. Patterns, in which a
/// star matches any text, are unchanged. A range is ascending and keeps leading zeros: "b08..b11".
/// Errors (kUsage): a range whose ends differ in more than a final number, that is descending, or
/// has more than 100,000 columns.
Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns);

}  // namespace somato
