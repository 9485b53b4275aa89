#include "som/data.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/core/threads.h"
#include "base/files/labels.h"

namespace somato::program {
namespace {

// The items of a flag, separated by commas.
Result<std::vector<std::string>> read_items(const Arguments& arguments, const std::string& flag) {
  std::vector<std::string> items;
  if (!arguments.has(flag)) return items;
  const std::string text = arguments.text(flag);
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    std::string item = text.substr(start, end - start);
    item.erase(0, std::min(item.find_first_not_of(' '), item.size()));
    item.erase(item.find_last_not_of(' ') + 1);
    if (item.empty()) {
      return fail(ErrorKind::kUsage, "a name is empty", "--" + flag,
                  "separate names or patterns by commas");
    }
    items.push_back(std::move(item));
    start = end + 1;
  }
  return items;
}

Result<DecimalMark> read_decimal(const Arguments& arguments) {
  if (!arguments.has("decimal")) return DecimalMark::kPoint;
  return choice_named<DecimalMark>("decimal mark", arguments.text("decimal"), "--decimal");
}

Result<std::optional<bool>> read_header(const Arguments& arguments) {
  if (!arguments.has("header")) return std::optional<bool>();
  const std::string header = arguments.text("header");
  if (header == "yes" || header == "no") return std::optional(header == "yes");
  return fail(ErrorKind::kUsage, fmt::format("must be yes or no, not '{}'", header), "--header");
}

}  // namespace

std::vector<Flag> table_flags() {
  return {{"--label-column", "Column of a CSV file with labels, by name or number from 1"},
          {"--columns-to-use",
           "Columns to use as features, separated by commas: names or patterns such as 'tax_*', or "
           "numbers from 1 and ranges such as 2..17 of columns without names. Default: all"},
          {"--skip", "Columns to leave out, in the same form"},
          {"--variable", "Array of an NPZ archive or a MAT-file with several"},
          {"--missing",
           fmt::format("Treatment of missing values (empty fields, NaN and words such as NA): {}",
                       "refuse; mean uses the mean of the known training values of the column; "
                       "nearest uses the value of the nearest complete row or, with a trained "
                       "map, finds the winner by the known values; leave_out does so in training, "
                       "too, and each weight learns from the rows that know its column. Default: "
                       "refuse")},
          {"--decimal", "Decimal separator in text, point or comma. Default: point"},
          {"--header",
           "Whether the first line of a text file contains names, yes or no. Default: "
           "yes if it contains a field that is not a number"}};
}

Positional data_positional(std::string text, bool required) {
  return {"DATA", std::move(text) + "; the rows of several files follow one another", required,
          true};
}

std::vector<std::string> data_files(const Arguments& arguments) {
  const auto given = arguments.lists.find("DATA");
  return given != arguments.lists.end() ? given->second : std::vector<std::string>();
}

std::vector<Flag> data_flags() {
  std::vector<Flag> flags = table_flags();
  flags.insert(flags.begin(),
               input_flag("--labels", "Text file with the labels of the rows, one per line"));
  return flags;
}

Result<CsvOptions> read_table_options(const Arguments& arguments) {
  CsvOptions options;
  options.label_column = arguments.text("label-column");
  options.variable = arguments.text("variable");
  SOMATO_TRY(auto header, read_header(arguments));
  SOMATO_TRY(auto decimal, read_decimal(arguments));
  SOMATO_TRY(auto use, read_items(arguments, "columns-to-use"));
  SOMATO_TRY(auto skip, read_items(arguments, "skip"));
  SOMATO_TRY(const auto missing, read_missing(arguments));
  options.header = header;
  options.decimal = decimal;
  options.columns.use = std::move(use);
  options.columns.skip = std::move(skip);
  options.keeps_missing = missing != MissingFill::kRefuse;
  return options;
}

Result<MissingFill> read_missing(const Arguments& arguments) {
  if (!arguments.has("missing")) return MissingFill::kRefuse;
  return choice_named<MissingFill>("way to fill missing values", arguments.text("missing"),
                                   "--missing");
}

Result<std::vector<std::string>> read_labels_of(const Arguments& arguments, std::size_t rows) {
  if (!arguments.has("labels")) return std::vector<std::string>();
  return read_labels(arguments.text("labels"), rows);
}

Result<void> check_labels_given_once(const Arguments& arguments) {
  if (!arguments.has("labels") || !arguments.has("label-column")) return {};
  return fail(ErrorKind::kUsage, "labels are given twice", "--label-column",
              "use either --labels or --label-column");
}

Result<std::size_t> read_threads(const Arguments& arguments) {
  return arguments.number("threads", 1).map([](std::optional<std::size_t> threads) {
    return std::min<std::size_t>(threads.value_or(available_threads()), 1024);
  });
}

Flag threads_flag() {
  return {"--threads", "Number of threads, which does not affect the result. Default: all cores"};
}

}  // namespace somato::program
