#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// The maximum length of a parsed text, in bytes.
inline constexpr std::size_t kLargestToml = std::size_t{16} << 20;

/// The table in the TOML `text`, from the source `where`: keys in the order of the text, each with
/// its `where:line`. Arrays of tables become lists of tables, other arrays Value::List. Errors
/// (kUsage, with `where:line:column`): wrong syntax, dates and times, arrays that mix types
/// (integers and other numbers may be mixed), tables and arrays more than 16 deep, a text of more
/// than 16 MiB.
Result<Table> parse_toml(std::string_view text, std::string_view where);

/// The table in the file at `path`; see parse_toml() and read_whole().
Result<Table> read_toml(const std::string& path);

/// The table as TOML: in each table first its values, then the tables in it; reading it gives the
/// same table but for the locations and this order.
std::string to_toml(const Table& table);

/// The table `name` in `table`; nullptr if there is none.
const Table* table_in(const Table& table, const std::string& name);

}  // namespace somato
