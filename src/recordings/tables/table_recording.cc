#include "recordings/tables/table_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/core/contains.h"
#include "base/files/labels.h"
#include "base/files/whole_file.h"
#include "base/numbers/known_values.h"
#include "base/numbers/whole_table.h"
#include "base/tables/csv_records.h"
#include "base/tables/csv_table_reader.h"
#include "base/text/flag_hint.h"
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

// The features of a trained system by their names; nothing if the table has no names.
Result<std::optional<WholeTable>> table_by_name(const std::string& bytes, const std::string& where,
                                                const RecordingParameters& parameters,
                                                CsvOptions options) {
  if (parameters.features.empty() || is_npy(bytes) || holds_variables(bytes)) {
    return std::optional<WholeTable>();
  }
  options.columns = {{}, {}, parameters.features};
  SOMATO_TRY(const auto names, names_in(bytes, where, options));
  if (names.empty()) return std::optional<WholeTable>();
  if (!contains(names, options.label_column)) options.label_column.clear();
  return whole_table(bytes, where, options).map([](WholeTable&& table) {
    return std::optional(std::move(table));
  });
}

// A trained system needs its features only: other columns of a table with names are left out,
// labels are not required, and columns without names may be only the features.
Result<WholeTable> table_for_system(const std::string& bytes, const std::string& where,
                                    const RecordingParameters& parameters) {
  CsvOptions options = options_of(parameters);
  options.keeps_empty_labels = true;
  SOMATO_TRY(auto by_name, table_by_name(bytes, where, parameters, options));
  if (by_name) return std::move(*by_name);
  auto as_trained = whole_table(bytes, where, options);
  if (as_trained || as_trained.error().kind != ErrorKind::kUsage) return as_trained;
  options.label_column.clear();
  options.variable.clear();
  options.columns = {};
  auto features = whole_table(bytes, where, options);
  return features ? std::move(features) : std::move(as_trained);
}

// A value that is not known anywhere cannot be replaced.
Result<void> check_known(const NumberTable& table, const std::string& where, bool trains) {
  KnownValues known;
  Result<void> checked;
  for (std::size_t row = 0; checked && row < table.values.rows(); ++row) {
    checked = known.take(table.values.row(row));
  }
  if (checked && trains) {
    checked = known.means(table.names).transform([](const auto& /*means*/) {});
    if (!checked) checked.error().advice += flag_hint("skip");
  }
  if (!checked) checked.error().where = where;
  return checked;
}

// The labels of a separate file are one for each row.
Result<void> add_labels_of_file(const RecordingParameters& parameters, WholeTable& whole) {
  if (parameters.labels.empty()) return {};
  if (!parameters.label_column.empty()) {
    return fail(ErrorKind::kUsage, "labels are given by a column and by a file", parameters.labels,
                "use one of them");
  }
  SOMATO_TRY(whole.table.labels, read_labels(parameters.labels, whole.table.values.rows()));
  return {};
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

// An exploration without a label has the name of those that a body explores.
std::vector<Label> labels_of(const WholeTable& whole, const RecordingParameters& parameters,
                             std::size_t row) {
  std::vector<Label> labels;
  const std::string name = name_of_labels(whole.columns);
  const bool are_given = !whole.table.labels.empty();
  if (are_given) {
    const std::string& value = whole.table.labels[row];
    labels.push_back({name, value.empty() ? "unknown" : value});
  }
  const bool is_taken = (are_given && name == "row") || parameters.label_column == "row";
  if (!is_taken) labels.push_back({"row", std::to_string(row + 1)});
  return labels;
}

Recording recording_of(const WholeTable& whole, const std::string& path,
                       const RecordingParameters& parameters) {
  const NumberTable& table = whole.table;
  const bool may_be_missing = parameters.missing == MissingValues::kMask;
  Recording recording;
  recording.explorations.reserve(table.values.rows());
  for (std::size_t row = 0; row < table.values.rows(); ++row) {
    recording.explorations.push_back(
        {labels_of(whole, parameters, row), path, {channel_of_row(table, row, may_be_missing)}});
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
  if (bytes.starts_with('{')) {
    return fail(ErrorKind::kData, "the file is JSON, neither a recording nor a table", path,
                "use a recording, or a table of numbers");
  }
  auto whole = parameters.for_system ? table_for_system(bytes, path, parameters)
                                     : whole_table(bytes, path, options_of(parameters));
  if (!whole) return fail(std::move(whole.error()));
  SOMATO_TRY_VOID(check_known(whole->table, path, !parameters.for_system));
  SOMATO_TRY_VOID(add_labels_of_file(parameters, *whole));
  return recording_of(*whole, path, parameters);
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
