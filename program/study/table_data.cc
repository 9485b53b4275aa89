#include "study/table_data.h"

#include <utility>

#include "som/data.h"

namespace somato::program {
namespace {

// The values that studies put in place of missing ones stand in the description of the system.
Result<MissingValues> missing_of(MissingFill fill) {
  if (fill == MissingFill::kRefuse) return MissingValues::kRefuse;
  if (fill == MissingFill::kMean) return MissingValues::kMask;
  return fail(ErrorKind::kUsage,
              fill == MissingFill::kLeaveOut
                  ? "a study cannot leave missing values out"
                  : "a study cannot replace missing values by those of the nearest row",
              "--missing", "use --missing mean");
}

}  // namespace

std::vector<Flag> table_data_flags() {
  std::vector<Flag> flags = data_flags();
  for (Flag& flag : flags) {
    if (flag.name == "--missing") {
      flag.text =
          "Treatment of missing values (empty fields, NaN and words such as NA): refuse; mean "
          "replaces them by the means of the known values, which 'suggest' writes as 'fill' into "
          "the study. Default: refuse";
    }
    flag.text = "For a table: " + flag.text;
  }
  return flags;
}

Result<bool> read_table_data(const Arguments& arguments, RecordingParameters& parameters) {
  SOMATO_TRY(auto options, read_table_options(arguments));
  SOMATO_TRY(const auto fill, read_missing(arguments));
  SOMATO_TRY(const auto missing, missing_of(fill));
  RecordingParameters given = parameters;
  SOMATO_TRY_VOID(check_labels_given_once(arguments));
  if (gives_labels(arguments)) given.label_column.clear();
  if (gives_labels(arguments)) given.labels = arguments.text("labels");
  if (arguments.has("label-column")) given.label_column = std::move(options.label_column);
  if (arguments.has("columns-to-use")) given.columns_to_use = std::move(options.columns.use);
  if (arguments.has("skip")) given.skip = std::move(options.columns.skip);
  if (arguments.has("variable")) given.variable = std::move(options.variable);
  if (arguments.has("missing")) given.missing = missing;
  if (arguments.has("decimal")) given.decimal = options.decimal;
  if (arguments.has("header")) given.header = options.header;
  const bool changes = given != parameters;
  parameters = std::move(given);
  return changes;
}

bool gives_labels(const Arguments& arguments) {
  return arguments.has("labels") || arguments.has("label-column");
}

std::string label_of_table(const RecordingParameters& parameters, const Recording& table,
                           const std::string& otherwise) {
  const bool has_labels = !parameters.label_column.empty() || !parameters.labels.empty();
  return has_labels ? table.explorations.front().labels.front().name : otherwise;
}

}  // namespace somato::program
