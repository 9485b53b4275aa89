#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "commands.h"
#include "somato/core/threads.h"
#include "somato/drawing/map_picture.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/recording/icub_grasp.h"
#include "somato/studies/study.h"
#include "terminal.h"

namespace somato::program {
namespace {

Result<StudyDescription> describe(const Arguments& arguments) {
  Result<Table> file = read_toml(arguments.text("STUDY"));
  if (!file) return fail(std::move(file.error()));
  Result<StudyDescription> description = read_study(*file);
  if (!description) return description;
  auto seeds = arguments.number("seeds", 1);
  if (!seeds) return fail(std::move(seeds.error()));
  if (*seeds) description->study.seeds = **seeds;
  return description;
}

Result<Recording> read_recording(const StudyDescription& description, const std::string& path) {
  switch (description.recording.format) {
    case RecordingFormat::kIcubGrasp:
      return import_icub_grasp(path);
  }
  return fail(ErrorKind::kUsage, "this recording format cannot be read");
}

// Made before the work begins: an hour of training should not end at a missing folder.
Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code) return {};
  return fail(ErrorKind::kSystem, "the folder cannot be made: " + code.message(), folder.string(),
              "give --out a folder that can be written to");
}

std::string picture_of(const StudyDescription& description, const StudyOutcome& outcome) {
  LabelPanel panel;
  panel.title = "Winners by " + description.study.label;
  panel.grid = outcome.map.grid();
  panel.class_names = outcome.classes.names;
  panel.winners = outcome.winners;
  panel.classes = outcome.classes.of_sample;
  const std::string caption =
      fmt::format("{} explorations, trained and shown on all of them; seed {}.",
                  outcome.winners.size(), description.study.first_seed);
  return draw_picture(description.study.name, caption, {panel});
}

std::string summary(const Metric& metric) {
  return fmt::format("{:.3f} +- {:.3f}", metric.mean(), metric.standard_deviation());
}

void print_table(const StudyResults& results) {
  for (const SystemResults& system : results.systems) {
    fmt::print("\n{}: {} by {}, {} samples, {} seeds\n", system.name, system.protocol, system.label,
               system.samples, results.seeds);
    for (const Metric& metric : system.metrics) {
      fmt::print("  {:<34}{}\n", metric.name, summary(metric));
    }
  }
}

Result<void> run(const Arguments& arguments) {
  auto description = describe(arguments);
  if (!description) return fail(std::move(description.error()));
  auto threads = arguments.number("threads", 1);
  if (!threads) return fail(std::move(threads.error()));
  const std::filesystem::path folder = arguments.text("out");
  auto recording = read_recording(*description, arguments.text("data"));
  if (!recording) return fail(std::move(recording.error()));
  if (auto made = make_folder(folder); !made) return made;
  const StudyOptions options{threads->value_or(available_threads()),
                             terminal_progress(description->study.name)};
  auto outcome = run_study(*description, *recording, options);
  if (!outcome) return fail(std::move(outcome.error()));
  const std::string results_path = (folder / "results.json").string();
  const std::string map_path = (folder / "map.svg").string();
  if (auto saved = save_whole(results_path, to_json(outcome->results)); !saved) return saved;
  if (auto saved = save_whole(map_path, picture_of(*description, *outcome)); !saved) return saved;
  print_table(outcome->results);
  fmt::print("\nWritten: {}, {}\n", results_path, map_path);
  return {};
}

}  // namespace

Command run_command() {
  return {"run",
          "Run a study: train maps on a recording and test them",
          {{"STUDY", "TOML file that describes the study", true}},
          {{"--data", "The recording, in the format that the study names", true},
           {"--out", "Folder for results.json and map.svg", true},
           {"--seeds", "Number of seeds, instead of the study's"},
           {"--threads", "Threads; the results do not depend on it. Default: all cores"}},
          {},
          run};
}

}  // namespace somato::program
