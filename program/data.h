#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "somato/core/samples.h"
#include "somato/graph/som_model.h"

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

/// Fails (kData) when a column has the same value in every row.
Result<void> refuse_constant_columns(const Data& data, const std::string& path);

/// A map and data that fit each other.
struct MapAndData {
  SomModel model;
  Data data;
  Samples samples;  ///< As the map takes them.
};

/// Reads the positionals `MAP` and `DATA`; kData when the map takes another number of columns.
Result<MapAndData> read_map_and_data(const Arguments& arguments);

/// The flag `--threads`, or all cores.
Result<std::size_t> read_threads(const Arguments& arguments);
Flag threads_flag();

}  // namespace somato::program
