#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flags/command_line.h"
#include "somato/files/csv.h"
#include "systems/signals/missing_values.h"

namespace somato::program {

/// The flags for reading a table, used by read_table_options() and read_missing().
std::vector<Flag> table_flags();

/// The flags for reading a table, and `--labels`.
std::vector<Flag> data_flags();

/// The positional `DATA` of commands that read tables: files whose rows follow one another.
Positional data_positional(std::string text, bool required = true);

/// The files that it names, or none.
std::vector<std::string> data_files(const Arguments& arguments);

/// The options for reading a table, from the flags. Errors: kUsage.
Result<CsvOptions> read_table_options(const Arguments& arguments);

/// The flag `--missing`. Errors: kUsage.
Result<MissingFill> read_missing(const Arguments& arguments);

/// The labels of a separate file, which must have `rows` lines, or none.
Result<std::vector<std::string>> read_labels_of(const Arguments& arguments, std::size_t rows);

/// Fails (kUsage) if labels are given in two ways.
Result<void> check_labels_given_once(const Arguments& arguments);

/// The flag `--threads`, or all cores.
Result<std::size_t> read_threads(const Arguments& arguments);
Flag threads_flag();

}  // namespace somato::program
