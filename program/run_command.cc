#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "commands.h"
#include "data.h"
#include "explanation.h"
#include "explore_table.h"
#include "output_folder.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/graph/system_model.h"
#include "somato/recording/format.h"
#include "somato/recording/layout.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study.h"
#include "study_data.h"
#include "terminal.h"
#include "winners_picture.h"

namespace somato::program {
namespace {

// Variations, claims and what to explore belong to 'reproduce', but are never wrong unnoticed.
Result<void> read_file(const std::string& path, const Table& file, ReproductionPlan& plan) {
  if (file.find("question")) {
    return fail(ErrorKind::kUsage, "the file asks a question about several systems", path,
                "answer it with 'somato reproduce'");
  }
  if (auto added = add_to_plan({path, file}, {}, plan); !added) return added;
  for (const ReproductionPart& part : plan.parts) {
    if (part.explore.entries.empty()) continue;
    if (auto read = read_explore_table(part.explore); !read) return fail(std::move(read.error()));
  }
  return {};
}

Result<StudyDescription> describe(const Arguments& arguments) {
  auto seeds = arguments.number("seeds", 1);
  if (!seeds) return fail(std::move(seeds.error()));
  Result<Table> file = read_toml(arguments.text("STUDY"));
  if (!file) return fail(std::move(file.error()));
  ReproductionPlan plan;
  if (auto read = read_file(arguments.text("STUDY"), *file, plan); !read) {
    return fail(std::move(read.error()));
  }
  StudyDescription description = std::move(plan.parts.front().description);
  if (*seeds) description.study.seeds = **seeds;
  return description;
}

std::string summary(const Metric& metric) {
  return fmt::format("{:.3f} +- {:.3f}", metric.mean(), metric.standard_deviation());
}

void print_table(const StudyResults& results) {
  for (const SystemResults& system : results.systems) {
    const std::string group = system.group.empty() ? "" : " (" + system.group + ")";
    fmt::print("\n{}: {}{} by {}, {} samples, {} seeds\n", system.name, system.protocol, group,
               system.label, system.samples, results.seeds);
    for (const Metric& metric : system.metrics) {
      fmt::print("  {:<33} {}\n", metric.name, summary(metric));
    }
  }
}

Result<void> save(const OutputFolder& folder, const StudyDescription& description,
                  const StudyOutcome& outcome) {
  if (auto saved = save_whole(folder.results(), to_json(outcome.results)); !saved) return saved;
  if (auto saved = save_whole(folder.map(), winners_picture(description, outcome)); !saved)
    return saved;
  return save_system(folder.system(), outcome.model.system, outcome.model.answer);
}

// Without data the channels are as their modules say.
Result<void> explain(const Arguments& arguments, const StudyDescription& description) {
  RecordingLayout layout;
  if (arguments.has("data")) {
    auto recording = read_study_data(description.recording.format, arguments.text("data"));
    if (!recording) return fail(std::move(recording.error()));
    layout = layout_of(*recording);
  }
  const auto system = System::build(description.system, std::move(layout));
  if (!system) return fail(system.error());
  fmt::print("{}", explanation(*system));
  return {};
}

Result<void> check_needed(const Arguments& arguments) {
  for (const std::string needed : {"data", "out"}) {
    if (arguments.has(needed)) continue;
    return fail(ErrorKind::kUsage, "--" + needed + " is required", "run", "see: somato run --help");
  }
  return {};
}

Result<std::optional<Recording>> read_test_data(const Arguments& arguments,
                                                RecordingFormat format) {
  if (!arguments.has("test-data")) return std::optional<Recording>{};
  return read_study_data(format, arguments.text("test-data")).map([](Recording recording) {
    return std::optional<Recording>(std::move(recording));
  });
}

Result<void> run_whole(const Arguments& arguments, const StudyDescription& description,
                       std::size_t threads) {
  const RecordingFormat format = description.recording.format;
  auto recording = read_study_data(format, arguments.text("data"));
  if (!recording) return fail(std::move(recording.error()));
  auto test_data = read_test_data(arguments, format);
  if (!test_data) return fail(std::move(test_data.error()));
  OutputFolder folder(arguments.text("out"), "--out");
  if (auto made = folder.make(); !made) return made;
  const StudyOptions options{threads, terminal_progress(description.study.name),
                             *test_data ? &**test_data : nullptr, folder.journal()};
  auto outcome = run_study(description, *recording, options);
  if (!outcome) {
    return fail(how_to_go_on(with_place(std::move(outcome.error()), arguments.text("data"))));
  }
  if (auto saved = save(folder, description, *outcome); !saved) return saved;
  std::error_code gone;
  std::filesystem::remove(folder.journal(), gone);
  print_table(outcome->results);
  fmt::print("\nWritten: {}, {}, {}\n", folder.results(), folder.map(), folder.system());
  return {};
}

Result<void> run_study_command(const Arguments& arguments) {
  const bool explains = arguments.has("explain");
  auto needed = explains ? Result<void>() : check_needed(arguments);
  if (!needed) return needed;
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  auto description = describe(arguments);
  if (!description) return fail(std::move(description.error()));
  return explains ? explain(arguments, *description) : run_whole(arguments, *description, *threads);
}

}  // namespace

Command run_command() {
  return {"run",
          "Run a study: train a system on a recording and test it",
          {{"STUDY", "TOML file that describes the study and its system", true}},
          {{"--data", "The recording: its file, or a folder of original files"},
           {"--test-data", "A recording of its own to test what learned from all of --data"},
           {"--out", "Folder for results.json, map.svg and system.somato"},
           {"--seeds", "Number of seeds, instead of the study's"},
           {"--explain", "Print modules, shapes, sizes and memory, and run nothing", false, false},
           threads_flag()},
          {},
          run_study_command};
}

}  // namespace somato::program
