#include <fmt/format.h>

#include <cstdio>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "data.h"
#include "result_output.h"
#include "somato/files/csv.h"
#include "somato/files/json_table.h"
#include "somato/files/whole_file.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_model.h"
#include "somato/maps/sample_range.h"
#include "study_data.h"

namespace somato::program {
namespace {

Result<RecordingFormat> read_format(const Arguments& arguments) {
  if (!arguments.has("format")) return RecordingFormat::kAutomatic;
  return choice_named<RecordingFormat>("format", arguments.text("format"), "--format");
}

Result<std::size_t> answering_map(const SystemModel& model, const std::string& path) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorKind::kData, what, path, "apply one that 'somato run' has saved");
  };
  if (!model.answer) return refuse("the system has no map that answers");
  auto map = model.system.find(model.answer->map);
  if (map && model.system.modules()[*map].output.rate == Rate::kFrame) {
    return refuse("the map that answers has frames coming in");
  }
  return map;
}

// The channels must be what they were when the system learned.
Result<void> check_layout(const System& system, const Recording& recording,
                          const std::string& path) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorKind::kData, "the recording does not fit the system: " + what, path,
                "apply it to recordings with the same channels");
  };
  const auto other = System::build(system.description(), layout_of(recording));
  if (!other) return refuse(other.error().what);
  for (std::size_t i = 0; i < other->modules().size(); ++i) {
    const SystemModule& module = other->modules()[i];
    const PortType& then = system.modules()[i].output;
    if (module.output.shape == then.shape) continue;
    return refuse(fmt::format("module '{}' gives {}, but {} when it learned", module.name,
                              to_string(module.output), to_string(then)));
  }
  return {};
}

// What the system says of an exploration, under the names of the columns.
Result<Table> answer_of(const SystemModel& model, const Som& som, const SignalView& input,
                        const Exploration& exploration, std::size_t number) {
  if (!is_in_range(input)) {
    return fail(ErrorKind::kData,
                fmt::format("exploration {} is too large for the map: what it takes has to be told "
                            "apart from others in single precision",
                            number),
                exploration.source, "leave the exploration out");
  }
  SomWorkspace workspace;
  const std::size_t winner = som.winner(input, workspace);
  const std::size_t label = model.answer->labels.classify(som, input, workspace);
  const std::string& name = model.answer->label;
  return Table{
      {},
      {entry("exploration", number), entry("source", exploration.source), entry("winner", winner),
       entry("row", som.grid().row_of(winner)), entry("column", som.grid().column_of(winner)),
       entry("distance", som.distance(input, winner, workspace)),
       entry(name, model.answer->classes[label]),
       entry("given_" + name, find_label(exploration, name).value_or(""))}};
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
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  const std::string data = arguments.text("DATA");
  const auto format = read_format(arguments);
  if (!format) return fail(format.error());
  const auto model = load_system(arguments.text("SYSTEM"));
  if (!model) return fail(model.error());
  const auto map = answering_map(*model, arguments.text("SYSTEM"));
  if (!map) return fail(map.error());
  const auto recording = read_study_data(*format, data);
  if (!recording) return fail(recording.error());
  if (auto same = check_layout(model->system, *recording, data); !same) return same;
  std::vector<std::size_t> all(recording->explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(model->system.modules().size(), all.size());
  const std::size_t input = model->system.modules()[*map].inputs.front();
  auto seen = evaluate(model->system, *recording, all, {input}, *threads, activations);
  if (!seen) return seen;
  std::vector<Table> answers;
  answers.reserve(all.size());
  for (const std::size_t exploration : all) {
    auto answer = answer_of(*model, *som_of(model->system, *map),
                            activations.find(input, exploration)->values[0],
                            recording->explorations[exploration], exploration + 1);
    if (!answer) return fail(std::move(answer.error()));
    answers.push_back(std::move(*answer));
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
          "Ask a trained system about the explorations of a recording",
          {{"SYSTEM", "A system that 'somato run' has saved", true},
           {"DATA", "The recording: its file, or a folder of original files", true}},
          {output_flag("-o,--output", "File for the answers, as CSV; standard output without it"),
           {"--json", "Answers as JSON instead of CSV", false, false},
           {"--format", "Format of the original files, when their names do not tell"},
           threads_flag()},
          {},
          apply};
}

}  // namespace somato::program
