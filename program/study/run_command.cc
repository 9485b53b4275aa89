#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "explore/explore_table.h"
#include "flags/commands.h"
#include "flags/output_folder.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "reproduce/part.h"
#include "reproduce/part_recordings.h"
#include "som/data.h"
#include "somato/graph/system_description.h"
#include "somato/recording/format.h"
#include "somato/recording/layout.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/study.h"
#include "somato/studies/study_parameters.h"
#include "studies/results/saved_model.h"
#include "studies/run/reproduction_run.h"
#include "studies/run/winners_picture.h"
#include "study/explanation.h"
#include "study/study_table.h"
#include "study/table_data.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

// Variations and explorations are only used by 'reproduce', but are always validated.
Result<void> read_file(const NamedFile& file, ReproductionPlan& plan) {
  if (file.content.find("question")) {
    return fail(ErrorKind::kUsage, "the file contains a question about several systems", file.name,
                "answer it with 'somato reproduce'");
  }
  SOMATO_TRY_VOID(add_to_plan(file, {}, plan));
  for (const ReproductionPart& part : plan.parts) {
    if (part.explore.entries.empty()) continue;
    SOMATO_TRY_VOID(read_explore_table(part.explore));
  }
  return {};
}

// A description that flags change is saved as it is then, not as in its file.
Result<void> read_table_flags(const Arguments& arguments, ReproductionPlan& plan) {
  for (ReproductionPart& part : plan.parts) {
    StudyDescription& description = part.description;
    SOMATO_TRY(const bool changes, read_table_data(arguments, description.recording));
    if (!changes && !gives_labels(arguments)) continue;
    description.text.clear();
    if (!gives_labels(arguments) || !arguments.has("data")) continue;
    SOMATO_TRY(const auto table, read_study_data(description.recording, arguments.text("data")));
    description.study.label = label_of_table(description.recording, table, description.study.label);
  }
  return {};
}

// The study of the file, which comes first, and its variations.
Result<ReproductionPlan> read_study_plan(const Arguments& arguments) {
  SOMATO_TRY(auto seeds, arguments.number("seeds", 1));
  SOMATO_TRY(const auto file, read_file_or_own(arguments.text("STUDY")));
  ReproductionPlan plan;
  SOMATO_TRY_VOID(read_file(file, plan));
  if (seeds) plan.parts.front().description.study.seeds = *seeds;
  SOMATO_TRY_VOID(read_table_flags(arguments, plan));
  return plan;
}

// Whether a system can be built is only known with a recording.
Result<void> check_variations(const ReproductionPlan& plan, PartRecordings& recordings) {
  SOMATO_TRY(const auto recording, recordings.get(plan.parts.front(), 0));
  for (std::size_t i = 1; i < plan.parts.size(); ++i) {
    SOMATO_TRY_VOID(
        System::build(plan.parts[i].description.system, layout_of(recording->recording)));
  }
  return {};
}

PartEvents events_in(const OutputFolder& folder, const std::string& name, const Part& part) {
  return {[name](std::size_t, std::size_t) { return terminal_progress(name); },
          [&folder, &part](std::size_t) { return part.is_whole() ? folder.journal() : ""; },
          [&](std::size_t, const StudyDescription& description, const StudyOutcome& outcome,
              PartResults& results) {
            return save_whole(folder.map(), winners_picture(description, outcome)).and_then([&] {
              return save_model(folder.path(), OutputFolder::kSystem, outcome.model, results);
            });
          },
          parts_folder(folder.path()).string()};
}

// Without data, channels are as declared by their modules.
Result<void> explain(const Arguments& arguments, const StudyDescription& description) {
  RecordingLayout layout;
  if (arguments.has("data")) {
    SOMATO_TRY(auto recording, read_study_data(description.recording, arguments.text("data")));
    layout = layout_of(recording);
  }
  SOMATO_TRY(const auto system, System::build(description.system, std::move(layout)));
  print_result(arguments, explanation(system), explanation_table(system));
  return {};
}

Result<void> check_needed(const Arguments& arguments) {
  for (const std::string needed : {"data", "out"}) {
    if (arguments.has(needed)) continue;
    return fail(ErrorKind::kUsage, "--" + needed + " is required", "run", "see: somato run --help");
  }
  return {};
}

// A test table has its columns in the order of the other one.
Result<RecordingParameters> how_to_read_test(const Arguments& arguments,
                                             const StudyDescription& description) {
  RecordingParameters how = description.recording;
  if (!is_table(arguments.text("test-data"))) return RecordingParameters{.format = how.format};
  SOMATO_TRY(const auto data, read_study_data(how, arguments.text("data")));
  how.features = data.explorations.front().channels.front().element_names;
  how.for_system = is_table(arguments.text("data"));
  return how;
}

// One recording, with the seeds of the study.
Result<PairsRequest> read_pairs(const Arguments& arguments, const StudyDescription& description,
                                std::size_t threads) {
  PairsRequest request{{description.study.seeds, description.study.first_seed, threads}, 1, {}};
  request.given = GivenRecordings::one(arguments.text("data"), description.recording);
  if (!arguments.has("test-data")) return request;
  SOMATO_TRY(const auto how, how_to_read_test(arguments, description));
  SOMATO_TRY(auto test, read_given(how, arguments.text("test-data")));
  request.test_data = std::make_shared<const PairedRecording>(std::move(test));
  return request;
}

// The results are written last, so that all files that they name exist.
Result<void> save_study(const Arguments& arguments, const OutputFolder& folder, const Part& part,
                        const Results& results) {
  const std::string json = to_json(results);
  SOMATO_TRY_VOID(save_whole(folder.results(), json));
  std::error_code gone;
  if (part.is_whole()) std::filesystem::remove(folder.journal(), gone);
  const std::string written =
      fmt::format("\nWritten: {}, {}, {}\n", folder.results(), folder.map(), folder.system());
  const ShownMetrics shown =
      arguments.has("all-metrics") ? ShownMetrics::kAll : ShownMetrics::kMain;
  print_summary(arguments, part_text(part) + study_table(results.parts.front(), shown) + written,
                json);
  return {};
}

// Runs the study without its variations, or a part of it; the part that completes it writes the
// results.
Result<void> run_in(const Arguments& arguments, const ReproductionPlan& plan, PartRunner& runner,
                    const OutputFolder& folder, const Part& part) {
  const ReproductionPlan study{{plan.parts.front()}, plan.claims};
  const auto events = [&](std::size_t) {
    return events_in(folder, study.parts.front().system, part);
  };
  if (!part.is_whole()) {
    SOMATO_TRY(const auto progress, run_part_of_reproduction(study, runner, part, events));
    if (!progress.complete()) {
      print_part(arguments, part, {progress.done, progress.trainings}, "training", "results.json");
      return {};
    }
  }
  SOMATO_TRY(const auto results, run_reproduction(study, runner, false, events));
  return save_study(arguments, folder, part, results);
}

Result<void> run_whole(const Arguments& arguments, const ReproductionPlan& plan,
                       std::size_t threads) {
  SOMATO_TRY(const auto part, read_part(arguments));
  SOMATO_TRY(auto pairs, read_pairs(arguments, plan.parts.front().description, threads));
  PartRecordings recordings(pairs, {});
  SOMATO_TRY_VOID(check_variations(plan, recordings));
  OutputFolder folder(arguments.text("out"), "--out");
  SOMATO_TRY_VOID(folder.make());
  SOMATO_TRY([[maybe_unused]] const auto lock, lock_work(folder.path(), part));
  PartRunner runner(pairs, recordings);
  auto ran = run_in(arguments, plan, runner, folder, part);
  if (ran) return {};
  return fail(how_to_go_on(with_place(std::move(ran.error()), arguments.text("data"))));
}

Result<void> run_study_command(const Arguments& arguments) {
  const bool explains = arguments.has("explain");
  auto needed = explains ? Result<void>() : check_needed(arguments);
  if (!needed) return needed;
  SOMATO_TRY(auto threads, read_threads(arguments));
  SOMATO_TRY(const auto plan, read_study_plan(arguments));
  return explains ? explain(arguments, plan.parts.front().description)
                  : run_whole(arguments, plan, threads);
}

std::vector<Flag> run_flags() {
  std::vector<Flag> flags{
      input_flag(
          "--data",
          "The recording: its file, a folder of original files, or a table of numbers, whose "
          "rows are explorations; required, as is --out, unless --explain is given"),
      input_flag("--test-data",
                 "Separate recording to test on; the system is then trained on all of --data"),
      folder_flag("-o,--out", "Folder for results.json, map.svg and system.somato",
                  OutputFolder::names()),
      part_flag("training"),
      {"--seeds", "Number of seeds, instead of the study's"},
      {"--all-metrics", "Print every metric, not only the main ones", false, false},
      {"--explain", "Print modules, shapes, sizes and memory, and run nothing", false, false},
      threads_flag(),
      json_flag()};
  const std::vector<Flag> of_tables = table_data_flags();
  flags.insert(flags.end(), of_tables.begin(), of_tables.end());
  return flags;
}

std::vector<KeySection> key_sections_of_studies() {
  return {
      {"Study files",
       "A study is a TOML file: the tables `[study]`, `[recording]` and, if needed, "
       "`[altered.NAME]`, and a system of the tables `[module.NAME]` and, if needed, "
       "`[[phase]]`. A key that is left out has its default; an unknown key is refused. Values "
       "are written in TOML notation; \"automatic\" is derived from the data as described for "
       "the key. A separate page lists the [types of modules](modules.md).",
       {key_table<StudyParameters>("`[study]`"), key_table<RecordingParameters>("`[recording]`"),
        key_table<Alteration>("`[altered.NAME]`"), key_table<PhaseDescription>("`[[phase]]`")}}};
}

}  // namespace

Command run_command() {
  return {"run",
          "Run a study: train a system on a recording and test it",
          {{"STUDY",
            "TOML file that describes the study and its system, or one that 'somato systems' lists",
            true, false, Role::kInput, own_file_names}},
          run_flags(),
          {},
          run_study_command,
          {},
          key_sections_of_studies};
}

}  // namespace somato::program
