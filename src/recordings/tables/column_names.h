#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Whether `column` depends on the names in a table: it holds a star, or is a range by place or two
/// indices.
bool is_column_pattern(std::string_view column);

/// Whether `column` is a range: "a..b".
bool is_column_range(std::string_view column);

/// The place of the column with a name, or the error that there is none.
using PlaceOfColumn = std::function<Result<std::size_t>(const std::string& name)>;

/// The columns of a range in a table with these names, in the order of the range: those with its
/// numbers, "t1..t16"; those with its two digits as row and column, "t00..t33", if these are all
/// that there are of the numbers; or those from the place of its first name to that of its last,
/// "thumb..pinky". Errors (kUsage): a descending range; those of `place_of`.
Result<std::vector<std::size_t>> columns_in_range(std::string_view range,
                                                  const std::vector<std::string>& header,
                                                  const PlaceOfColumn& place_of);

/// Whether `name` matches `pattern`, whose stars match any text, including none.
bool fits_column_pattern(std::string_view pattern, std::string_view name);

/// The columns of a list of names and ranges: "a", "b1..b3" are a, b1, b2, b3. A range is ascending
/// and keeps leading zeros: "b08..b11". What depends on a table is unchanged: patterns, in which a
/// star matches any text, ranges by place and possible ranges of two indices. Errors (kUsage): a
/// range without an end, that is descending, or has more than 100,000 columns.
Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns);

}  // namespace somato
