#include <fmt/format.h>

#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "data.h"
#include "files/json_table.h"
#include "files/whole_file.h"
#include "maps/sample_range.h"
#include "result_output.h"
#include "somato/files/csv.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_model.h"
#include "study_data.h"
#include "system_fit.h"

namespace somato::program {
namespace {

Result<RecordingFormat> read_format(const Arguments& arguments) {
  if (!arguments.has("format")) return RecordingFormat::kAutomatic;
  return choice_named<RecordingFormat>("format", arguments.text("format"), "--format");
}

Result<std::size_t> answering_map(const SystemModel& model, const std::string& path) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorKind::kData, what, path, "save one with 'somato run'");
  };
  if (!model.answer) return refuse("the system has no output map");
  auto map = model.system.find(model.answer->map);
  if (map && model.system.modules()[*map].output.rate == Rate::kFrame) {
    return refuse("the output map takes one input per frame; it needs one per exploration");
  }
  return map;
}

// The system's output for an exploration, by the names of the columns.
Result<Table> answer_of(const SystemModel& model, const Som& som, const SignalView& input,
                        const Exploration& exploration, std::size_t number) {
  if (!is_in_range(input)) {
    return fail(ErrorKind::kData,
                fmt::format("exploration {} has values too large for the map, which computes "
                            "distances in single precision",
                            number),
                exploration.source, "leave the exploration out");
  }
  SomWorkspace workspace;
  const std::size_t winner = som.winner(input, workspace);
  const SystemAnswer& answer = *model.answer;
  const std::size_t nearest = som.winner_among(answer.labels.labelled(), input, workspace);
  const std::size_t label = *answer.labels[nearest];
  const std::string& name = answer.label;
  std::optional<double> novelty;
  if (answer.novelty) novelty = answer.novelty->of(label, som.distance(input, nearest, workspace));
  const bool unknown = novelty && is_unknown(*novelty);
  Table table{
      {},
      {entry("exploration", number), entry("source", exploration.source), entry("winner", winner),
       entry("row", som.grid().row_of(winner)), entry("column", som.grid().column_of(winner)),
       entry("distance", som.distance(input, winner, workspace)),
       entry(name, unknown ? std::string(kUnknownAnswer) : answer.classes[label]),
       entry("given_" + name, find_label(exploration, name).value_or(""))}};
  if (!novelty) return table;
  table.entries.push_back(entry("novelty", *novelty));
  table.entries.push_back(entry("nearest_" + name, answer.classes[label]));
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
  SOMATO_TRY(const auto model, load_system(arguments.text("SYSTEM")));
  SOMATO_TRY(const auto map, answering_map(model, arguments.text("SYSTEM")));
  SOMATO_TRY(const auto recording, read_study_data(format, data));
  SOMATO_TRY_VOID(check_fit(model.system, recording, data));
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(model.system.modules().size(), all.size());
  const std::size_t input = model.system.modules()[map].inputs.front();
  auto seen = evaluate(model.system, recording, all, {input}, threads, activations);
  if (!seen) return seen;
  std::vector<Table> answers;
  answers.reserve(all.size());
  for (const std::size_t exploration : all) {
    SOMATO_TRY(auto answer, answer_of(model, *som_of(model.system, map),
                                      activations.find(input, exploration)->values[0],
                                      recording.explorations[exploration], exploration + 1));
    answers.push_back(std::move(answer));
  }
  const std::string text = arguments.has("json")
                               ? to_json(Table{{}, {entry("answers", std::move(answers))}})
                               : csv_of(answers);
  if (arguments.has("output")) return save_whole(arguments.text("output"), text);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return {};
}

}  // namespace

Command apply_command() {
  return {"apply",
          "Apply a trained system to the explorations of a recording",
          {{"SYSTEM", "Trained system, saved by 'somato run'", true},
           {"DATA", "Recording: its file, or a folder of original files", true}},
          {output_flag("-o,--output", "CSV file for the results. Default: standard output"),
           {"--json", "Write JSON instead of CSV", false, false},
           {"--format", "Format of the original files, if it cannot be detected"},
           threads_flag()},
          {},
          apply};
}

}  // namespace somato::program
