#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "flags/output.h"
#include "flags/output_folder.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "reproduce/part.h"
#include "reproduce/part_recordings.h"
#include "reproduce/result_tables.h"
#include "som/data.h"
#include "somato/studies/claim.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/study_parameters.h"
#include "studies/results/saved_model.h"
#include "studies/run/reproduction_run.h"
#include "studies/run/winners_picture.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kQuestions = "questions";
constexpr const char* kAnnounced = "announced";

// The request from the command line.
struct ReproductionRequest {
  ReproductionPlan plan;
  bool everything = false;  ///< Systems that do not fit the given recordings are skipped.
  PairsRequest pairs;
  Part part;
  std::filesystem::path out;
};

Result<NamedFile> find_file(const std::string& name, const OwnSystems& own) {
  if (name.ends_with(".toml")) {
    return read_file_or_own(name);
  }
  std::vector<std::string> known{kAll, kQuestions, kAnnounced};
  for (const auto* files : {&own.systems, &own.recorded, &own.questions, &own.announced,
                            &own.announced_questions, &own.studies}) {
    for (const NamedFile& file : *files) {
      if (file.name == name) return file;
      known.push_back(file.name);
    }
  }
  return fail(unknown_name("system", name, "reproduce", known));
}

void append(const std::vector<NamedFile>& more, std::vector<NamedFile>& files) {
  files.insert(files.end(), more.begin(), more.end());
}

// With data, "all" also includes the systems for data sets, which do not explore.
Result<std::vector<NamedFile>> requested_files(const std::vector<std::string>& names,
                                               const OwnSystems& own,
                                               ReproductionRequest& request) {
  std::vector<NamedFile> files;
  for (const std::string& name : names) {
    request.everything =
        request.everything || name == kAll || name == kQuestions || name == kAnnounced;
    if (name == kAll) {
      append(own.systems, files);
      if (request.pairs.given) append(own.recorded, files);
    } else if (name == kQuestions) {
      append(own.questions, files);
    } else if (name == kAnnounced) {
      append(own.announced_questions, files);
    } else {
      SOMATO_TRY(auto file, find_file(name, own));
      files.push_back(std::move(file));
    }
  }
  return files;
}

// Claims and journals of interrupted runs are identified by names. A system for data sets may have
// the same name as one that explores, because it is run on other recordings.
Result<void> check_names(const ReproductionPlan& plan) {
  std::set<std::pair<std::string, RecordingFormat>> names;
  for (const ReproductionPart& part : plan.parts) {
    if (names.emplace(title_of(part), part.description.recording.format).second) continue;
    return fail(ErrorKind::kUsage, "'" + title_of(part) + "' is requested twice",
                part.description.where, "request it once, or rename one of them");
  }
  return {};
}

Result<void> check_exploring(const ReproductionRequest& request) {
  for (const ReproductionPart& part : request.plan.parts) {
    auto right = check_explorable(part, request.pairs.given.has_value());
    if (!right) return right;
  }
  return {};
}

Result<void> read_plan(const Arguments& arguments, ReproductionRequest& request) {
  SOMATO_TRY(const auto own, own_systems());
  const auto found = arguments.lists.find("SYSTEM");
  const auto names =
      found == arguments.lists.end() ? std::vector<std::string>{kAll} : found->second;
  SOMATO_TRY(const auto files, requested_files(names, own, request));
  const std::vector<NamedFile> systems = questionable_systems(own);
  for (const NamedFile& file : files) {
    SOMATO_TRY_VOID(add_to_plan(file, systems, request.plan));
  }
  return check_names(request.plan).and_then([&] { return check_exploring(request); });
}

Result<void> read_numbers(const Arguments& arguments, ReproductionRequest& request) {
  const auto read = [&](const std::string& flag, std::size_t least, auto& value) -> Result<void> {
    SOMATO_TRY(auto number, arguments.number(flag, least));
    if (number) value = *number;
    return {};
  };
  return read("pairs", 1, request.pairs.pairs)
      .and_then([&] { return read("recordings", 1, request.pairs.recordings); })
      .and_then([&] { return read("seed", 0, request.pairs.seed); });
}

Result<ReproductionRequest> read_reproduction_request(const Arguments& arguments) {
  ReproductionRequest request;
  SOMATO_TRY(auto part, read_part(arguments));
  request.part = std::move(part);
  request.out = arguments.has("out") ? arguments.text("out") : "out/reproduction";
  auto read = read_numbers(arguments, request)
                  .and_then([&] { return read_threads_and_data(arguments, request.pairs); })
                  .and_then([&] { return read_plan(arguments, request); });
  if (!read) return fail(std::move(read.error()));
  return request;
}

std::string file_name_of(const ReproductionPart& part) {
  std::string name = part.question.empty() ? part.system : part.question + "-" + part.system;
  if (!part.variation.empty()) name += "-" + part.variation;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

// The first map of a system, and its trained system; not of the variations of a question.
Result<void> save_first(const std::filesystem::path& out, const ReproductionPart& part,
                        const StudyDescription& description, const StudyOutcome& outcome,
                        PartResults& results) {
  if (!part.question.empty() && !part.variation.empty()) return {};
  const auto map = out / "maps" / (file_name_of(part) + ".svg");
  auto saved = save_whole(map.string(), winners_picture(description, outcome));
  if (!saved) return saved;
  return save_model(out, "systems/" + file_name_of(part) + ".somato", outcome.model, results);
}

PartEvents events_of(const ReproductionRequest& request, std::size_t number) {
  const ReproductionPart& part = request.plan.parts[number];
  const std::string title =
      fmt::format("{} ({} of {})", title_of(part), number + 1, request.plan.parts.size());
  return {[title](std::size_t, std::size_t) { return terminal_progress(title); },
          [&](std::size_t recording) {
            if (!request.part.is_whole()) return std::string();
            const auto name = fmt::format("{}-{}.journal", file_name_of(part), recording);
            return (request.out / "unfinished" / name).string();
          },
          [&](std::size_t index, const StudyDescription& description, const StudyOutcome& outcome,
              PartResults& results) {
            return index == 0 ? save_first(request.out, part, description, outcome, results)
                              : Result<void>();
          },
          parts_folder(request.out).string()};
}

Result<void> save_reproduction(const Arguments& arguments, const ReproductionRequest& request,
                               const Results& results) {
  const std::string path = (request.out / "results.json").string();
  const std::string json = to_json(results);
  SOMATO_TRY_VOID(save_whole(path, json));
  std::error_code gone;
  if (request.part.is_whole()) std::filesystem::remove_all(request.out / "unfinished", gone);
  const std::string written =
      fmt::format("\nWritten: {}, maps in {}\n", path, (request.out / "maps").string());
  print_summary(arguments, part_text(request.part) + reproduction_table(results) + written, json);
  return {};
}

// Runs the plan, or a part of it; the part that completes it writes the results.
Result<void> run_request(const Arguments& arguments, ReproductionRequest& request) {
  PartRecordings recordings(request.pairs, request.out / "recordings");
  PartRunner runner(request.pairs, recordings);
  const auto events = [&](std::size_t number) { return events_of(request, number); };
  if (!request.part.is_whole()) {
    SOMATO_TRY(const auto progress,
               run_part_of_reproduction(request.plan, runner, request.part, events));
    if (!progress.complete()) {
      print_part(arguments, request.part, {progress.done, progress.trainings}, "training",
                 "results.json");
      return {};
    }
  }
  SOMATO_TRY(const auto results,
             run_reproduction(request.plan, runner, request.everything, events));
  return save_reproduction(arguments, request, results);
}

Result<void> make_folders(const ReproductionRequest& request) {
  for (const char* folder : {"recordings", "maps", "systems"}) {
    SOMATO_TRY_VOID(make_folder(request.out / folder));
  }
  if (request.part.is_whole()) SOMATO_TRY_VOID(make_folder(request.out / "unfinished"));
  return check_output((request.out / "results.json").string());
}

Result<void> run_reproduce(const Arguments& arguments) {
  SOMATO_TRY(auto request, read_reproduction_request(arguments));
  SOMATO_TRY_VOID(make_folders(request));
  SOMATO_TRY([[maybe_unused]] const auto lock, lock_work(request.out, request.part));
  auto ran = run_request(arguments, request);
  return ran ? Result<void>() : fail(how_to_go_on(std::move(ran.error())));
}

std::vector<KeySection> key_sections_of_reproduction() {
  return {
      {"Files of `somato reproduce`",
       "Tables in addition to those of a study, and the question of a file about several systems "
       "([reproduction](reproduction.md)). `[variation.NAME]` has the tables and keys that it "
       "changes, and `systems`, the list of systems to which it applies. \"automatic\" means "
       "none here.",
       {key_table<ExploreParameters>("`[explore]`"), key_table<Claim>("`[[claim]]`"),
        key_table<QuestionParameters>("`[question]`")}}};
}

}  // namespace

Command reproduce_command() {
  return {
      "reproduce",
      "Run the papers' systems on recordings of simulated bodies, and compare the results with the "
      "published ones",
      {{"SYSTEM",
        "Systems and questions by name, or TOML files; 'all' selects the nine systems, with --data "
        "also those for data sets, 'questions' all questions about them, and 'announced' all "
        "comparisons with systems beyond the papers. Default: all",
        false, true, Role::kInput, own_file_names}},
      {{"--pairs", "Pairs of recording and seed for each system. Default: 100"},
       {"--recordings", "Number of independent recordings among the pairs. Default: 6"},
       {"--seed", "First seed of exploration and training. Default: 2011"},
       part_flag("training"),
       given_recordings_flag(),
       test_recording_flag(),
       folder_flag("-o,--out",
                   "Folder for results.json, maps and recordings. Default: out/reproduction",
                   {"results.json"}),
       threads_flag(),
       json_flag()},
      {},
      run_reproduce,
      {},
      key_sections_of_reproduction};
}

}  // namespace somato::program
