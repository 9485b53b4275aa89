#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "somato/core/samples.h"
#include "somato/files/csv.h"

namespace somato::program {

/// Rows of numbers from a file, with a label a row if the command line names any.
struct Data {
  std::vector<std::string> features;  ///< Names of the columns, or empty.
  Samples samples;
  std::vector<std::string> labels;  ///< One a row, or empty.
};

/// The flags that read_data() understands.
std::vector<Flag> data_flags();

/// Reads the file that the positional `DATA` names, and its labels. Errors: those of the files, and
/// kData when there are not as many labels as rows.
Result<Data> read_data(const Arguments& arguments);

/// The parts of it: how the flags say a text file is to be read; the labels of a file of their own,
/// which has to have `rows`, or none; that labels are not given in two ways (kUsage).
Result<CsvOptions> read_csv_options(const Arguments& arguments);
Result<std::vector<std::string>> read_labels_of(const Arguments& arguments, std::size_t rows);
Result<void> check_labels_given_once(const Arguments& arguments);

/// Fails (kData) when the columns of the data at `path` have other names than those of the map, if
/// both have names: in another order they would give answers that look right.
Result<void> check_names(const std::vector<std::string>& of_map,
                         const std::vector<std::string>& of_data, const std::string& path);

/// The flag `--threads`, or all cores.
Result<std::size_t> read_threads(const Arguments& arguments);
Flag threads_flag();

}  // namespace somato::program
