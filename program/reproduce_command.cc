#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "commands.h"
#include "data.h"
#include "folder_lock.h"
#include "output.h"
#include "part_runner.h"
#include "reproduction_recordings.h"
#include "reproduction_table.h"
#include "result_output.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/graph/system_model.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study.h"
#include "study_data.h"
#include "terminal.h"
#include "winners_picture.h"

namespace somato::program {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kQuestions = "questions";

// What was asked for on the command line.
struct ReproductionRequest {
  ReproductionPlan plan;
  bool everything = false;  ///< Systems that do not apply to what is given are passed over.
  PairsRequest pairs;
  std::filesystem::path out;
};

Result<NamedFile> find_file(const std::string& name, const OwnSystems& own) {
  if (name.ends_with(".toml")) {
    return read_file_or_own(name).map(
        [&](Table content) { return NamedFile{name, std::move(content)}; });
  }
  std::vector<std::string> known{kAll, kQuestions};
  for (const auto* files : {&own.systems, &own.recorded, &own.questions, &own.studies}) {
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

// With data, all are the systems for data sets, too: these explore nothing.
Result<std::vector<NamedFile>> asked_files(const std::vector<std::string>& names,
                                           const OwnSystems& own, ReproductionRequest& request) {
  std::vector<NamedFile> files;
  for (const std::string& name : names) {
    request.everything = request.everything || name == kAll || name == kQuestions;
    if (name == kAll) {
      append(own.systems, files);
      if (request.pairs.given) append(own.recorded, files);
    } else if (name == kQuestions) {
      append(own.questions, files);
    } else {
      auto file = find_file(name, own);
      if (!file) return fail(std::move(file.error()));
      files.push_back(std::move(*file));
    }
  }
  return files;
}

std::string title_of(const ReproductionPart& part) {
  std::string title = part.question.empty() ? part.system : part.question + ": " + part.system;
  if (!part.variation.empty()) title += ", " + part.variation;
  return title;
}

// Claims and what is kept of an interrupted run go by names. A system for data sets may be called
// like the one that explores: it is run on other recordings.
Result<void> check_names(const ReproductionPlan& plan) {
  std::set<std::pair<std::string, RecordingFormat>> names;
  for (const ReproductionPart& part : plan.parts) {
    if (names.emplace(title_of(part), part.description.recording.format).second) continue;
    return fail(ErrorKind::kUsage, "'" + title_of(part) + "' is asked for twice",
                part.description.where, "ask for it once, or give one another name");
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
  const auto own = own_systems();
  if (!own) return fail(own.error());
  const auto found = arguments.lists.find("SYSTEM");
  const auto names =
      found == arguments.lists.end() ? std::vector<std::string>{kAll} : found->second;
  const auto files = asked_files(names, *own, request);
  if (!files) return fail(files.error());
  for (const NamedFile& file : *files) {
    if (auto added = add_to_plan(file, own->systems, request.plan); !added) return added;
  }
  return check_names(request.plan).and_then([&] { return check_exploring(request); });
}

Result<void> read_numbers(const Arguments& arguments, ReproductionRequest& request) {
  const auto read = [&](const std::string& flag, std::size_t least, auto& value) -> Result<void> {
    auto number = arguments.number(flag, least);
    if (!number) return fail(std::move(number.error()));
    if (*number) value = **number;
    return {};
  };
  return read("pairs", 1, request.pairs.pairs)
      .and_then([&] { return read("recordings", 1, request.pairs.recordings); })
      .and_then([&] { return read("seed", 0, request.pairs.seed); });
}

Result<ReproductionRequest> read_reproduction_request(const Arguments& arguments) {
  ReproductionRequest request;
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

// Runs the parts of a request one after the other and keeps what they find.
class Reproduction {
 public:
  Reproduction(ReproductionRequest& request)
      : request_(request), runner_(request.pairs, request.out / "recordings") {}

  Result<void> run() {
    results_.seed = request_.pairs.seed;
    results_.pairs = request_.pairs.pairs;
    for (std::size_t i = 0; i < request_.plan.parts.size(); ++i) {
      place_ = fmt::format(" ({} of {})", i + 1, request_.plan.parts.size());
      auto ran = run_part(request_.plan.parts[i]);
      if (!ran) return ran;
    }
    results_.claims = judge(request_.plan.claims, results_.parts);
    return {};
  }

  const ReproductionResults& results() const { return results_; }

 private:
  std::filesystem::path journal(const ReproductionPart& part, std::size_t recording) const {
    return request_.out / "unfinished" /
           fmt::format("{}-{}.journal", file_name_of(part), recording);
  }

  PartEvents events_of(const ReproductionPart& part) {
    return {[this, &part](std::size_t, std::size_t) {
              return terminal_progress(title_of(part) + place_);
            },
            [this, &part](std::size_t recording) { return journal(part, recording); },
            [this, &part](std::size_t index, const PairedRecording& recording,
                          const StudyDescription& description, const StudyOutcome& outcome) {
              remember(recording.info);
              return draw(part, index, description, outcome);
            }};
  }

  Result<void> run_part(const ReproductionPart& part) {
    auto ran = runner_.run(part, events_of(part));
    if (!ran) return fail(std::move(ran.error()));
    if (ran->misfit) return pass_over(part, std::move(*ran->misfit));
    results_.parts.push_back(std::move(ran->results));
    return {};
  }

  // The first map of a system as it stands, and the trained system behind it.
  Result<void> draw(const ReproductionPart& part, std::size_t index,
                    const StudyDescription& description, const StudyOutcome& outcome) const {
    if (index > 0 || !part.question.empty()) return {};
    const auto path = request_.out / "maps" / (file_name_of(part) + ".svg");
    if (auto saved = save_whole(path.string(), winners_picture(description, outcome)); !saved) {
      return saved;
    }
    const auto system = request_.out / "systems" / (file_name_of(part) + ".somato");
    return save_system(system.string(), outcome.model.system, outcome.model.answer);
  }

  void remember(const RecordingInfo& info) {
    const auto known = std::any_of(results_.recordings.begin(), results_.recordings.end(),
                                   [&](const RecordingInfo& one) { return one.name == info.name; });
    if (!known) results_.recordings.push_back(info);
  }

  Result<void> pass_over(const ReproductionPart& part, Error error) {
    if (!request_.everything) return fail(std::move(error));
    results_.not_applicable.push_back({title_of(part), to_string(error)});
    return {};
  }

  ReproductionRequest& request_;
  PartRunner runner_;
  ReproductionResults results_;
  std::string place_;
};

Result<void> make_folders(const std::filesystem::path& out) {
  for (const char* folder : {"recordings", "maps", "systems", "unfinished"}) {
    std::error_code code;
    std::filesystem::create_directories(out / folder, code);
    if (!code) continue;
    return fail(ErrorKind::kSystem, "the folder cannot be made: " + code.message(),
                (out / folder).string(), "give --out a folder that can be written to");
  }
  return check_output((out / "results.json").string());
}

Result<void> run_reproduce(const Arguments& arguments) {
  auto request = read_reproduction_request(arguments);
  if (!request) return fail(std::move(request.error()));
  if (auto made = make_folders(request->out); !made) return made;
  const auto lock = FolderLock::take(request->out);
  if (!lock) return fail(lock.error());
  Reproduction reproduction(*request);
  if (auto ran = reproduction.run(); !ran) return fail(how_to_go_on(std::move(ran.error())));
  const std::string path = (request->out / "results.json").string();
  if (auto saved = save_whole(path, to_json(reproduction.results())); !saved) return saved;
  std::error_code gone;
  std::filesystem::remove_all(request->out / "unfinished", gone);
  const std::string written =
      fmt::format("\nWritten: {}, maps in {}\n", path, (request->out / "maps").string());
  print_summary(arguments, reproduction_table(reproduction.results()) + written,
                to_json(reproduction.results()));
  return {};
}

}  // namespace

Command reproduce_command() {
  return {
      "reproduce",
      "Run the papers' systems on recordings of simulated bodies, beside what was published",
      {{"SYSTEM",
        "Systems and questions by name, or TOML files; all, or none named: the nine systems, with "
        "--data also those for data sets; questions: all questions about them",
        false, true, Role::kInput, own_file_names}},
      {{"--pairs", "Pairs of recording and seed for each system; 100 unless given"},
       {"--recordings", "Independent recordings they are spread over; 6 unless given"},
       {"--seed", "First seed of exploring and of training; 2011 unless given"},
       input_flag(
           "--data",
           "Recordings instead of exploring: a file, a folder of files, a data set, or a folder "
           "of data sets"),
       input_flag("--test-data", "A separate recording to test on"),
       folder_flag("-o,--out",
                   "Folder for results.json, maps and recordings; out/reproduction unless given",
                   {"results.json"}),
       threads_flag(),
       json_flag()},
      {},
      run_reproduce};
}

}  // namespace somato::program
