#include "data.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "memory_flag.h"
#include "somato/core/threads.h"
#include "somato/files/labels.h"
#include "somato/files/number_file.h"

namespace somato::program {

std::vector<Flag> data_flags() {
  return {input_flag("--labels", "Text file with the label of each row, one a line"),
          {"--label-column", "Column of a CSV file that holds labels, by name or number from 1"},
          {"--header",
           "Whether the first line of a text file holds names, yes or no; default: "
           "when it holds something that is no number"}};
}

Result<CsvOptions> read_csv_options(const Arguments& arguments) {
  CsvOptions options;
  options.label_column = arguments.text("label-column");
  if (!arguments.has("header")) return options;
  const std::string header = arguments.text("header");
  if (header != "yes" && header != "no") {
    return fail(ErrorKind::kUsage, fmt::format("must be yes or no, not '{}'", header), "--header");
  }
  options.header = header == "yes";
  return options;
}

Result<std::vector<std::string>> read_labels_of(const Arguments& arguments, std::size_t rows) {
  if (!arguments.has("labels")) return std::vector<std::string>();
  const std::string path = arguments.text("labels");
  auto labels = read_labels(path);
  if (!labels || labels->size() == rows) return labels;
  return fail(ErrorKind::kData, fmt::format("{} labels for {} rows", labels->size(), rows), path,
              "write one label a line, in the order of the rows");
}

Result<void> check_labels_given_once(const Arguments& arguments) {
  if (!arguments.has("labels") || !arguments.has("label-column")) return {};
  return fail(ErrorKind::kUsage, "labels are given twice", "--label-column",
              "use either --labels or --label-column");
}

// What is no regular file cannot be read in parts, and has no size before it has been read.
Result<std::size_t> limit_of(const Arguments& arguments) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(arguments.text("DATA"), ignored)) return kLargestFile;
  return read_memory(arguments);
}

Result<Data> read_data(const Arguments& arguments) {
  if (auto once = check_labels_given_once(arguments); !once) return fail(std::move(once.error()));
  const auto options = read_csv_options(arguments);
  if (!options) return fail(options.error());
  const auto limit = limit_of(arguments);
  if (!limit) return fail(limit.error());
  auto table = read_numbers(arguments.text("DATA"), *options, *limit);
  if (!table) return fail(std::move(table.error()));
  auto labels = read_labels_of(arguments, table->values.rows());
  if (!labels) return fail(std::move(labels.error()));
  if (!arguments.has("labels")) labels = std::move(table->labels);
  return Data{std::move(table->names), Samples(std::move(table->values)), std::move(*labels)};
}

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

Result<std::size_t> read_threads(const Arguments& arguments) {
  return arguments.number("threads", 1).map([](std::optional<std::size_t> threads) {
    return std::min<std::size_t>(threads.value_or(available_threads()), 1024);
  });
}

Flag threads_flag() {
  return {"--threads", "Threads; the result does not depend on it. Default: all cores"};
}

}  // namespace somato::program
