#pragma once

#include <string>
#include <string_view>

#include "base/tables/table_columns.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// A table and the roles of its file's columns.
struct WholeTable {
  NumberTable table;
  TableColumns columns;
};

/// The table in the text of a CSV file; see parse_csv().
Result<WholeTable> csv_table(std::string_view text, std::string_view where,
                             const CsvOptions& options);

/// Whether a file with these first bytes (kMatHeader of them, or all) is an NPZ archive or a
/// MAT-file, whose arrays have names.
bool holds_variables(std::string_view start);

/// The table in the bytes of a file; see read_numbers().
Result<WholeTable> whole_table(const std::string& bytes, const std::string& where,
                               const CsvOptions& options);

}  // namespace somato
