#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/tables/csv_records.h"
#include "somato/core/result.h"

namespace somato {

/// The names of columns in a header, as unguarded_text() gives them. A column without a name, or
/// with a blank one, is named by its number: (column 1).
std::vector<std::string> names_in_header(const std::vector<CsvField>& header);

/// Whether `name` of `column`, counted from 0, stands for none: that of names_in_header(), or one
/// that pandas (Unnamed: 0) and readr (...1) give a column without a name when they read it.
bool is_nameless(std::string_view name, std::size_t column);

/// The numbers of `columns`, from 1, separated by commas, as a list of columns of a table with
/// these names is written in a shell; a column whose number is the name of another has its name.
std::string columns_by_number(const std::vector<std::string>& names,
                              const std::vector<std::size_t>& columns);

/// The error (kData) for `columns`, at least one, of `width` that have no names. `alternative` is
/// what to do if the file is not changed, such as "skip 1".
Error nameless_columns(const std::vector<std::size_t>& columns, std::size_t width,
                       std::string_view where, std::string_view alternative);

/// The error (kData) for the row in `fields` of a table of `width` columns, which has another
/// number of fields. `follows_header`: its header precedes it immediately.
Error wrong_number_of_fields(const std::vector<CsvField>& fields, std::size_t width,
                             bool follows_header, std::string place, std::string_view advice);

}  // namespace somato
