#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/text/json_table.h"
#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "flags/result_output.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "som/row_output.h"
#include "somato/files/csv.h"
#include "somato/files/npy.h"

namespace somato::program {
namespace {

// The format of the winners: a CSV table, or with --json a list of objects.
class WinnerFormat {
 public:
  WinnerFormat(const SomModel& model, bool is_json) : model_(model), is_json_(is_json) {}

  std::string begin() const {
    if (is_json_) return "[";
    return fmt::format("sample,winner,row,column,distance{}\n",
                       model_.classes.empty() ? "" : ",label");
  }

  // `sample` is a number from 1.
  std::string row(std::size_t sample, std::size_t winner, double distance,
                  std::optional<std::size_t> its_class) const {
    const Grid& grid = model_.som.grid();
    const std::string label = its_class ? model_.classes[*its_class] : std::string();
    if (!is_json_) {
      return fmt::format("{},{},{},{},{:.9g}{}\n", sample, winner, grid.row_of(winner),
                         grid.column_of(winner), distance, its_class ? "," + csv_field(label) : "");
    }
    Table table{
        {},
        {entry("sample", sample), entry("winner", winner), entry("row", grid.row_of(winner)),
         entry("column", grid.column_of(winner)), entry("distance", distance)}};
    if (its_class) table.entries.push_back(entry("label", label));
    const std::string json = to_json(table);
    return (sample == 1 ? "\n" : ",\n") + json.substr(0, json.size() - 1);
  }

  std::string end() const { return is_json_ ? "\n]\n" : ""; }

 private:
  const SomModel& model_;
  bool is_json_;
};

// Rows of which the first has the number `first`, from 0.
std::string winners_text(const SomModel& model, const WinnerFormat& format, const Samples& samples,
                         std::size_t first) {
  std::string text;
  SomWorkspace workspace;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const SignalView sample = samples[i];
    const std::size_t winner = model.som.winner(sample, workspace);
    std::optional<std::size_t> its_class;
    if (!model.classes.empty()) its_class = model.labels.classify(model.som, sample, workspace);
    text +=
        format.row(first + i + 1, winner, model.som.distance(sample, winner, workspace), its_class);
  }
  return text;
}

// A process that comes after others continues their output.
Result<void> write_own_winners(const MapAndRows& both, const WinnerFormat& format, bool is_first,
                               RowOutput& output) {
  PreparedRows prepared(both.model, both.rows);
  std::size_t done = both.rows.first;
  bool has_begun = !is_first;
  SOMATO_TRY_VOID(for_each_part(prepared.samples(), [&](const Samples& part) {
    std::string text = winners_text(both.model, format, part, done);
    if (!std::exchange(has_begun, true)) text.insert(0, format.begin());
    done += part.count();
    return output.write(text);
  }));
  return has_begun ? Result<void>() : output.write(format.begin());
}

Result<void> write_winners(const MapAndRows& both, const Arguments& arguments,
                           ProcessGroup* processes) {
  SOMATO_TRY(auto output, RowOutput::begin(arguments.text("output"), processes));
  const WinnerFormat format(both.model, arguments.has("json"));
  const bool is_first = !processes || processes->is_first();
  const bool is_last = !processes || processes->rank() + 1 == processes->size();
  return output.commit(write_own_winners(both, format, is_first, output).and_then([&] {
    return is_last ? output.write(format.end()) : Result<void>();
  }));
}

Result<void> write_own_activity(const MapAndRows& both, RowOutput& output) {
  const Som& som = both.model.som;
  PreparedRows prepared(both.model, both.rows);
  std::vector<float> activity(som.neurons());
  SomWorkspace workspace;
  return for_each_part(prepared.samples(), [&](const Samples& part) -> Result<void> {
    for (std::size_t i = 0; i < part.count(); ++i) {
      som.activity(part[i], workspace, activity);
      SOMATO_TRY_VOID(output.write(npy_numbers(activity)));
    }
    return {};
  });
}

Result<void> write_activity(const MapAndRows& both, const std::string& path,
                            ProcessGroup* processes) {
  SOMATO_TRY(auto output, RowOutput::begin(path, processes));
  const bool is_first = !processes || processes->is_first();
  const std::string start = npy_start(both.rows.count, both.model.som.neurons());
  return output.commit((is_first ? output.write(start) : Result<void>()).and_then([&] {
    return write_own_activity(both, output);
  }));
}

Result<void> map_with(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(const auto both, read_map_and_rows(arguments, processes));
  if (arguments.has("activity")) {
    SOMATO_TRY_VOID(write_activity(both, arguments.text("activity"), processes));
  }
  SOMATO_TRY_VOID(write_winners(both, arguments, processes));
  if (!processes || processes->is_first()) note_columns_and_filled(both.rows);
  return {};
}

Result<void> map(const Arguments& arguments) {
  SOMATO_TRY(const auto processes, Processes::join());
  return processes.leave(map_with(arguments, processes.group()));
}

}  // namespace

Command som_map_command() {
  std::vector<Flag> flags{
      output_flag("-o,--output", "CSV file instead of standard output"),
      output_flag("--activity", "NPY file for the activity of every neuron, one row per sample")};
  const std::vector<Flag> of_table = table_flags();
  flags.insert(flags.end(), of_table.begin(), of_table.end());
  flags.push_back(memory_flag());
  flags.push_back({"--json", "Write winners as JSON instead of CSV", false, false});
  return {"som map",
          "Find the winner of each row on a map, and its label if the map has labels",
          {{"MAP", "A trained map", true}, data_positional("NPY file or text, as for training")},
          std::move(flags),
          {},
          map};
}

}  // namespace somato::program
