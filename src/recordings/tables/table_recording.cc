#include "recordings/tables/table_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/core/contains.h"
#include "base/files/labels.h"
#include "base/files/whole_file.h"
#include "base/numbers/whole_table.h"
#include "base/tables/csv_records.h"
#include "base/tables/csv_table_reader.h"
#include "base/text/text.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

CsvOptions options_of(const RecordingParameters& parameters) {
  CsvOptions options;
  options.label_column = parameters.label_column;
  options.variable = parameters.variable;
  options.header = parameters.header;
  options.decimal = parameters.decimal;
  options.columns.use = parameters.columns_to_use;
  options.columns.skip = parameters.skip;
  options.keeps_missing = parameters.missing == MissingValues::kMask;
  return options;
}

// The names of all columns of a text, or none.
Result<std::vector<std::string>> names_in(const std::string& bytes, const std::string& where,
                                          CsvOptions options) {
  options.label_column.clear();
  SOMATO_TRY(const auto text, text_of(bytes, where));
  CsvTableReader reader(CsvRecords(text, where), where, options);
  return reader.begin().map([&] { return reader.columns().names; });
}

// A trained system needs its features only: other columns of a table with names are left out, and
// labels are not required.
Result<WholeTable> table_for_features(const std::string& bytes, const std::string& where,
                                      const RecordingParameters& parameters) {
  CsvOptions const options = options_of(parameters);
  CsvOptions by_name = options;
  by_name.columns = {{}, {}, parameters.features};
  const bool has_names = !is_npy(bytes) && !holds_variables(bytes);
  const auto names = has_names ? names_in(bytes, where, by_name) : std::vector<std::string>();
  if (names && names->empty()) return whole_table(bytes, where, options);
  if (names && !contains(*names, by_name.label_column)) by_name.label_column.clear();
  return whole_table(bytes, where, by_name);
}

// The labels of a separate file are one for each row.
Result<void> add_labels_of_file(const RecordingParameters& parameters, WholeTable& whole) {
  if (parameters.labels.empty()) return {};
  if (!parameters.label_column.empty()) {
    return fail(ErrorKind::kUsage, "labels are given by a column and by a file", parameters.labels,
                "use one of them");
  }
  SOMATO_TRY(whole.table.labels, read_labels(parameters.labels));
  const std::size_t rows = whole.table.values.rows();
  if (whole.table.labels.size() == rows) return {};
  return fail(ErrorKind::kData,
              fmt::format("{} labels for {} rows", whole.table.labels.size(), rows),
              parameters.labels, "write one label per line, in the order of the rows");
}

// The name of a column without a name is "label".
std::string name_of_labels(const TableColumns& columns) {
  return columns.label && !columns.names.empty() ? columns.names[*columns.label] : "label";
}

// A missing value is marked as invalid. If values may be missing, all rows have marks.
Channel channel_of_row(const NumberTable& table, std::size_t row, bool may_be_missing) {
  const std::span<const float> values = table.values.row(row);
  Channel channel;
  channel.name = "columns";
  channel.element_names = table.names;
  channel.frames = Matrix<float>(1, values.size(), {values.begin(), values.end()});
  if (!may_be_missing) return channel;
  channel.valid = Matrix<std::uint8_t>(1, values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) continue;
    channel.frames(0, i) = 0.0F;
    channel.valid(0, i) = 0;
  }
  return channel;
}

Recording recording_of(const WholeTable& whole, const std::string& path, bool may_be_missing) {
  const NumberTable& table = whole.table;
  const std::string label = name_of_labels(whole.columns);
  Recording recording;
  recording.explorations.reserve(table.values.rows());
  for (std::size_t row = 0; row < table.values.rows(); ++row) {
    Exploration exploration;
    if (!table.labels.empty()) exploration.labels.push_back({label, table.labels[row]});
    if (table.labels.empty() || label != "row") {
      exploration.labels.push_back({"row", std::to_string(row + 1)});
    }
    exploration.source = path;
    exploration.channels.push_back(channel_of_row(table, row, may_be_missing));
    recording.explorations.push_back(std::move(exploration));
  }
  return recording;
}

}  // namespace

Result<Recording> read_table_recording(const std::string& path,
                                       const RecordingParameters& parameters) {
  if (parameters.format != RecordingFormat::kAutomatic) {
    return fail(ErrorKind::kData,
                fmt::format("the format is {}, and the file is not a recording",
                            choice_name(parameters.format)),
                path, "use the folder of the data, or leave out the format to read a table");
  }
  SOMATO_TRY(const std::string bytes, read_whole(path));
  auto whole = parameters.features.empty() ? whole_table(bytes, path, options_of(parameters))
                                           : table_for_features(bytes, path, parameters);
  if (!whole) return fail(std::move(whole.error()));
  SOMATO_TRY_VOID(add_labels_of_file(parameters, *whole));
  return recording_of(*whole, path, parameters.missing == MissingValues::kMask);
}

Result<void> check_without_table(const RecordingParameters& parameters, const std::string& where) {
  const RecordingParameters defaults;
  for (const auto& parameter : RecordingParameters::declarations().all()) {
    if (parameter.info.name == "format") continue;
    if (parameter.read(parameters) == parameter.read(defaults)) continue;
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' is a setting of tables, and the data are a recording",
                            parameter.info.name),
                where, "leave it out, or use a table of numbers");
  }
  return {};
}

}  // namespace somato
