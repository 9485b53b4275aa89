#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "commands.h"
#include "data.h"
#include "explanation.h"
#include "explore_table.h"
#include "folder_lock.h"
#include "output_folder.h"
#include "result_output.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/graph/system_model.h"
#include "somato/recording/format.h"
#include "somato/recording/layout.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study.h"
#include "study_data.h"
#include "study_table.h"
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

// The study of the file, which comes first, and its variations.
Result<ReproductionPlan> read_study_plan(const Arguments& arguments) {
  auto seeds = arguments.number("seeds", 1);
  if (!seeds) return fail(std::move(seeds.error()));
  Result<Table> file = read_file_or_own(arguments.text("STUDY"));
  if (!file) return fail(std::move(file.error()));
  ReproductionPlan plan;
  if (auto read = read_file(arguments.text("STUDY"), *file, plan); !read) {
    return fail(std::move(read.error()));
  }
  if (*seeds) plan.parts.front().description.study.seeds = **seeds;
  return plan;
}

// Only a recording tells whether a system can be built.
Result<void> check_variations(const ReproductionPlan& plan, const Recording& recording) {
  for (std::size_t i = 1; i < plan.parts.size(); ++i) {
    const auto system = System::build(plan.parts[i].description.system, layout_of(recording));
    if (!system) return fail(system.error());
  }
  return {};
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
  print_result(arguments, explanation(*system), explanation_table(*system));
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

Result<void> run_whole(const Arguments& arguments, const ReproductionPlan& plan,
                       std::size_t threads) {
  const StudyDescription& description = plan.parts.front().description;
  const RecordingFormat format = description.recording.format;
  auto recording = read_study_data(format, arguments.text("data"));
  if (!recording) return fail(std::move(recording.error()));
  if (auto buildable = check_variations(plan, *recording); !buildable) return buildable;
  auto test_data = read_test_data(arguments, format);
  if (!test_data) return fail(std::move(test_data.error()));
  OutputFolder folder(arguments.text("out"), "--out");
  if (auto made = folder.make(); !made) return made;
  const auto lock = FolderLock::take(arguments.text("out"));
  if (!lock) return fail(lock.error());
  const StudyOptions options{threads, terminal_progress(description.study.name),
                             *test_data ? &**test_data : nullptr, folder.journal()};
  auto outcome = run_study(description, *recording, options);
  if (!outcome) {
    return fail(how_to_go_on(with_place(std::move(outcome.error()), arguments.text("data"))));
  }
  if (auto saved = save(folder, description, *outcome); !saved) return saved;
  std::error_code gone;
  std::filesystem::remove(folder.journal(), gone);
  const std::string written =
      fmt::format("\nWritten: {}, {}, {}\n", folder.results(), folder.map(), folder.system());
  print_summary(arguments, study_table(outcome->results) + written, to_json(outcome->results));
  return {};
}

Result<void> run_study_command(const Arguments& arguments) {
  const bool explains = arguments.has("explain");
  auto needed = explains ? Result<void>() : check_needed(arguments);
  if (!needed) return needed;
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  const auto plan = read_study_plan(arguments);
  if (!plan) return fail(plan.error());
  return explains ? explain(arguments, plan->parts.front().description)
                  : run_whole(arguments, *plan, *threads);
}

}  // namespace

Command run_command() {
  return {
      "run",
      "Run a study: train a system on a recording and test it",
      {{"STUDY",
        "TOML file that describes the study and its system, or one that 'somato systems' lists",
        true, false, Role::kInput, own_file_names}},
      {input_flag("--data",
                  "The recording: its file, or a folder of original files; required, as is --out, "
                  "unless --explain is given"),
       input_flag("--test-data", "A separate recording to test what learned from all of --data"),
       folder_flag("-o,--out", "Folder for results.json, map.svg and system.somato",
                   OutputFolder::names()),
       {"--seeds", "Number of seeds, instead of the study's"},
       {"--explain", "Print modules, shapes, sizes and memory, and run nothing", false, false},
       threads_flag(),
       json_flag()},
      {},
      run_study_command};
}

}  // namespace somato::program
