#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "commands.h"
#include "data.h"
#include "output.h"
#include "somato/drawing/map_picture.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/recording/format.h"
#include "somato/studies/study.h"
#include "terminal.h"

namespace somato::program {
namespace {

Result<StudyDescription> describe(const Arguments& arguments) {
  auto seeds = arguments.number("seeds", 1);
  if (!seeds) return fail(std::move(seeds.error()));
  Result<Table> file = read_toml(arguments.text("STUDY"));
  if (!file) return fail(std::move(file.error()));
  Result<StudyDescription> description = read_study(*file);
  if (!description) return description;
  if (*seeds) description->study.seeds = **seeds;
  return description;
}

// The folder for the results, made before the work begins: an hour of training should not end at a
// missing folder. When there are no results a folder that was made for them goes again.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {}
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;
  ~OutputFolder() {
    std::error_code not_empty;
    for (const std::filesystem::path& folder : made_) std::filesystem::remove(folder, not_empty);
  }

  Result<void> make() {
    std::error_code code;
    std::filesystem::path missing = std::filesystem::absolute(path_, code).lexically_normal();
    for (; !std::filesystem::exists(missing, code); missing = missing.parent_path()) {
      made_.push_back(missing);
    }
    std::filesystem::create_directories(path_, code);
    if (code) {
      return fail(ErrorKind::kSystem, "the folder cannot be made: " + code.message(),
                  path_.string(), "give --out a folder that can be written to");
    }
    return check_output(results()).and_then([&] { return check_output(map()); });
  }

  std::string results() const { return (path_ / "results.json").string(); }
  std::string map() const { return (path_ / "map.svg").string(); }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // innermost first
};

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

// What a recording as a whole lacks is told with its path.
Error with_place(Error error, const std::string& data) {
  if (error.kind == ErrorKind::kData && error.where.empty()) error.where = data;
  return error;
}

Result<void> save(const OutputFolder& folder, const StudyDescription& description,
                  const StudyOutcome& outcome) {
  if (auto saved = save_whole(folder.results(), to_json(outcome.results)); !saved) return saved;
  return save_whole(folder.map(), picture_of(description, outcome));
}

Result<void> run(const Arguments& arguments) {
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  auto description = describe(arguments);
  if (!description) return fail(std::move(description.error()));
  auto recording = load_recording(description->recording.format, arguments.text("data"));
  if (!recording) return fail(std::move(recording.error()));
  OutputFolder folder(arguments.text("out"));
  if (auto made = folder.make(); !made) return made;
  const StudyOptions options{*threads, terminal_progress(description->study.name)};
  auto outcome = run_study(*description, *recording, options);
  if (!outcome) return fail(with_place(std::move(outcome.error()), arguments.text("data")));
  if (auto saved = save(folder, *description, *outcome); !saved) return saved;
  print_table(outcome->results);
  fmt::print("\nWritten: {}, {}\n", folder.results(), folder.map());
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
           threads_flag()},
          {},
          run};
}

}  // namespace somato::program
