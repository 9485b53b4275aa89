#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "base/text/json_table.h"
#include "flags/commands.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "som/data.h"
#include "somato/files/csv.h"
#include "somato/graph/answers.h"
#include "somato/graph/system_model.h"
#include "study/contribution_table.h"
#include "study/system_fit.h"

namespace somato::program {
namespace {

Result<RecordingFormat> read_format(const Arguments& arguments) {
  if (!arguments.has("format")) return RecordingFormat::kAutomatic;
  return choice_named<RecordingFormat>("format", arguments.text("format"), "--format");
}

// A label with the name of another column of the output has an addition.
std::string column_name(const std::string& label) {
  for (const char* taken :
       {"exploration", "source", "winner", "row", "column", "distance", "novelty"}) {
    if (label == taken) return label + "_label";
  }
  return label;
}

// The system's output for an exploration, by the names of the columns.
Table table_of(const SystemModel& model, const Grid& grid, const InputAnswer& given,
               const Exploration& exploration, std::size_t number) {
  const SystemAnswer& answer = *model.answer;
  const std::string name = column_name(answer.label);
  Table table{{},
              {entry("exploration", number), entry("source", exploration.source),
               entry("winner", given.winner), entry("row", grid.row_of(given.winner)),
               entry("column", grid.column_of(given.winner)),
               entry("distance", given.winner_distance), entry(name, given.name(answer.classes)),
               entry("given_" + name, find_label(exploration, answer.label).value_or(""))}};
  if (!given.novelty) return table;
  table.entries.push_back(entry("novelty", *given.novelty));
  table.entries.push_back(entry("nearest_" + name, answer.classes[given.nearest]));
  return table;
}

std::string csv_cell(const Table::Entry& cell) {
  const auto& value = std::get<Value>(cell.content);
  if (const auto* text = std::get_if<std::string>(&value.content)) return csv_field(*text);
  const auto* number = std::get_if<double>(&value.content);
  return number ? fmt::format("{:.9g}", *number) : to_toml(value);
}

// `answers`, at least one, which have the same columns.
std::string csv_of(const std::vector<Table>& answers) {
  std::vector<std::string> cells;
  cells.reserve(answers.front().entries.size());
  for (const Table::Entry& cell : answers.front().entries) cells.push_back(csv_field(cell.name));
  std::string csv = fmt::format("{}\n", fmt::join(cells, ","));
  for (const Table& answer : answers) {
    cells.clear();
    for (const Table::Entry& cell : answer.entries) cells.push_back(csv_cell(cell));
    csv += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return csv;
}

Result<void> apply(const Arguments& arguments) {
  SOMATO_TRY(auto threads, read_threads(arguments));
  const std::string data = arguments.text("DATA");
  SOMATO_TRY(const auto format, read_format(arguments));
  SOMATO_TRY(auto loaded, load_system(arguments.text("SYSTEM")));
  const auto shared = std::make_shared<const SystemModel>(std::move(loaded));
  const SystemModel& model = *shared;
  auto map = answering_map(model);
  if (!map) map.error().where = arguments.text("SYSTEM");
  if (!map) return fail(std::move(map.error()));
  RecordingParameters how = recording_for(model, data);
  how.format = format;
  SOMATO_TRY(const auto recording, read_study_data(how, data));
  SOMATO_TRY_VOID(check_fit(model.system, recording, data));
  SOMATO_TRY(const auto inputs, inputs_to_answer(model, recording, threads));
  if (arguments.has("contributions")) {
    SOMATO_TRY_VOID(
        save_contributions(arguments.text("contributions"), shared, recording, inputs, threads));
  }
  const std::vector<InputAnswer> given = answers_to(model, inputs, threads);
  const Grid grid = grid_of(model.system, *map);
  std::vector<Table> tables;
  tables.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    tables.push_back(table_of(model, grid, given[i], recording.explorations[i], i + 1));
  }
  const std::string text = arguments.has("json")
                               ? to_json(Table{{}, {entry("answers", std::move(tables))}})
                               : csv_of(tables);
  if (arguments.has("output")) return save_whole(arguments.text("output"), text);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return {};
}

}  // namespace

Command apply_command() {
  return {"apply",
          "Apply a trained system to the explorations of a recording",
          {{"SYSTEM", "Trained system, saved by 'somato run'", true},
           {"DATA",
            "Recording: its file, a folder of original files, or a table, which is read as the one "
            "of the system's training, with columns selected by name",
            true}},
          {output_flag("-o,--output", "CSV file for the results. Default: standard output"),
           output_flag("--contributions",
                       "CSV file for what separates the answer from the next class: a row for each "
                       "exploration and element of a channel, whose contributions sum to the "
                       "difference of the two distances"),
           {"--json", "Write JSON instead of CSV", false, false},
           {"--format", "Format of the original files, if it cannot be detected"},
           threads_flag()},
          {},
          apply};
}

}  // namespace somato::program
