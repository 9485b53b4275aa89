#include "data.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "somato/core/threads.h"
#include "somato/files/labels.h"
#include "somato/files/number_file.h"

namespace somato::program {
namespace {

Result<void> add_labels(const Arguments& arguments, Data& data) {
  if (!arguments.has("labels")) return {};
  const std::string path = arguments.text("labels");
  auto labels = read_labels(path);
  if (!labels) return fail(std::move(labels.error()));
  if (labels->size() != data.samples.count()) {
    return fail(ErrorKind::kData,
                fmt::format("{} labels for {} rows", labels->size(), data.samples.count()), path,
                "write one label a line, in the order of the rows");
  }
  data.labels = std::move(*labels);
  return {};
}

bool is_constant(const Samples& samples, std::size_t column) {
  const float first = samples[0].values[column];
  for (std::size_t i = 1; i < samples.count(); ++i) {
    if (samples[i].values[column] != first) return false;
  }
  return true;
}

// Columns in another order than the map's would give answers that look right.
Result<void> check_names(const std::vector<std::string>& of_map,
                         const std::vector<std::string>& of_data, const std::string& path) {
  if (of_map.empty() || of_data.empty()) return {};
  for (std::size_t i = 0; i < of_map.size(); ++i) {
    if (of_map[i] == of_data[i]) continue;
    return fail(ErrorKind::kData,
                fmt::format("column {} is '{}', but the map was trained on '{}' there", i + 1,
                            of_data[i], of_map[i]),
                path, "give the columns in the order of the training data");
  }
  return {};
}

}  // namespace

std::vector<Flag> data_flags() {
  return {{"--labels", "Text file with the label of each row, one a line"},
          {"--label-column", "Column of a CSV file that holds labels, by name or number from 1"},
          {"--header",
           "Whether the first line of a text file holds names, yes or no; default: "
           "when it holds something that is no number"}};
}

Result<Data> read_data(const Arguments& arguments) {
  if (arguments.has("labels") && arguments.has("label-column")) {
    return fail(ErrorKind::kUsage, "labels are given twice", "--label-column",
                "use either --labels or --label-column");
  }
  CsvOptions options;
  options.label_column = arguments.text("label-column");
  if (arguments.has("header")) {
    const std::string header = arguments.text("header");
    if (header != "yes" && header != "no") {
      return fail(ErrorKind::kUsage, fmt::format("must be yes or no, not '{}'", header),
                  "--header");
    }
    options.header = header == "yes";
  }
  auto table = read_numbers(arguments.text("DATA"), options);
  if (!table) return fail(std::move(table.error()));
  Data data{std::move(table->names), Samples(std::move(table->values)), std::move(table->labels)};
  if (auto added = add_labels(arguments, data); !added) return fail(std::move(added.error()));
  return data;
}

Result<void> refuse_constant_columns(const Data& data, const std::string& path) {
  for (std::size_t column = 0; column < data.samples.size(); ++column) {
    if (!is_constant(data.samples, column)) continue;
    const std::string name =
        data.features.empty() ? "" : fmt::format(" ('{}')", data.features[column]);
    return fail(ErrorKind::kData,
                fmt::format("column {}{} has the same value in every row", column + 1, name), path,
                "leave the column out, or pass --keep-constant-columns");
  }
  return {};
}

Result<MapAndData> read_map_and_data(const Arguments& arguments) {
  auto model = load_som_model(arguments.text("MAP"));
  if (!model) return fail(std::move(model.error()));
  auto data = read_data(arguments);
  if (!data) return fail(std::move(data.error()));
  if (data->samples.size() != model->som.input_size()) {
    return fail(ErrorKind::kData,
                fmt::format("the rows have {} numbers, but the map takes {}", data->samples.size(),
                            model->som.input_size()),
                arguments.text("DATA"), "give data with the columns that the map was trained on");
  }
  if (auto fit = check_names(model->features, data->features, arguments.text("DATA")); !fit) {
    return fail(std::move(fit.error()));
  }
  MapAndData both{std::move(*model), std::move(*data), {}};
  both.samples = both.model.prepare(both.data.samples);
  return both;
}

Result<std::size_t> read_threads(const Arguments& arguments) {
  return arguments.number("threads", 1).map([](std::optional<std::size_t> threads) {
    return std::min<std::size_t>(threads.value_or(available_threads()), 1024);
  });
}

Flag threads_flag() {
  return {"--threads", "Threads; the result does not depend on it. Default: all cores"};
}

}  // namespace somato::program
