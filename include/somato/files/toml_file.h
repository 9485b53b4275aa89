#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// The table that the TOML in `text`, which is `where`, describes: keys in the order of the text,
/// each with its `where:line`. Arrays of tables become lists of tables, other arrays Value::List.
/// Errors (kUsage, with `where:line:column`): wrong syntax, dates and times, arrays that mix types
/// (integers and other numbers may stand together), tables and arrays more than 16 deep, a text of
/// more than 16 MiB.
Result<Table> parse_toml(std::string_view text, std::string_view where);

/// The table in the file at `path`; see parse_toml() and read_whole().
Result<Table> read_toml(const std::string& path);

}  // namespace somato
