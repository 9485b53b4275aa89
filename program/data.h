#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "command_line.h"
#include "somato/codes/missing_values.h"
#include "somato/files/csv.h"

namespace somato::program {

/// The flags that say how a table is read: what read_table_options() and read_missing() understand.
std::vector<Flag> table_flags();

/// These, and `--labels`.
std::vector<Flag> data_flags();

/// How the flags say that the table is to be read. Errors: kUsage.
Result<CsvOptions> read_table_options(const Arguments& arguments);

/// The flag `--missing`. Errors: kUsage.
Result<MissingFill> read_missing(const Arguments& arguments);

/// The labels of a file of their own, which has to have `rows`, or none.
Result<std::vector<std::string>> read_labels_of(const Arguments& arguments, std::size_t rows);

/// Fails (kUsage) when labels are given in two ways.
Result<void> check_labels_given_once(const Arguments& arguments);

/// The flag `--threads`, or all cores.
Result<std::size_t> read_threads(const Arguments& arguments);
Flag threads_flag();

}  // namespace somato::program
