#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "commands.h"
#include "data.h"
#include "output.h"
#include "pages.h"
#include "report_recordings.h"
#include "report_things.h"
#include "somato/files/whole_file.h"
#include "somato/graph/system_model.h"
#include "somato/report/report.h"
#include "terminal.h"
#include "version.h"
#include "wording.h"

namespace somato::program {
namespace {

namespace fs = std::filesystem;
using Model = std::shared_ptr<const ReportModel>;

constexpr std::size_t kLargestResults = std::size_t{64} << 20;  // bytes

Result<std::string_view> find_page() {
  for (const Page& page : pages()) {
    if (page.name == "report.html") return page.text;
  }
  return fail(ErrorKind::kUsage, "this program was built without its pages", "report",
              "install npm and build it again");
}

Result<void> check_results(const Arguments& arguments) {
  const std::vector<std::string>& paths = arguments.lists.at("RESULTS");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code missing;
      if (!fs::equivalent(paths[i], paths[j], missing)) continue;
      return fail(ErrorKind::kUsage, "the file is given twice", paths[i], "name each once");
    }
  }
  return {};
}

Result<Model> load_model(const std::string& path) {
  return load_system(path).map([&](SystemModel model) -> Model {
    return std::make_shared<const ReportModel>(ReportModel{path, std::move(model)});
  });
}

// That of 'somato run', and those of 'somato reproduce'.
std::vector<std::string> models_beside(const std::string& results) {
  const fs::path folder = fs::path(results).parent_path();
  std::vector<std::string> paths;
  std::error_code missing;
  if (fs::exists(folder / "system.somato", missing)) {
    paths.push_back((folder / "system.somato").string());
  }
  for (const auto& entry : fs::directory_iterator(folder / "systems", missing)) {
    if (entry.path().extension() == ".somato") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Whatever lies beside the results is only used if it can be.
void add_models_beside(const std::string& results, ReportFile& file) {
  for (const std::string& path : models_beside(results)) {
    auto model = load_model(path);
    if (model) {
      file.models.push_back(std::move(*model));
    } else {
      file.missing.push_back("A trained system beside results.json cannot be read (" +
                             to_string(model.error()) + ").");
    }
  }
}

Result<std::vector<ReportFile>> read_files(const Arguments& arguments) {
  Model named;
  if (arguments.has("model")) {
    auto model = load_model(arguments.text("model"));
    if (!model) return fail(std::move(model.error()));
    named = std::move(*model);
  }
  std::vector<ReportFile> files;
  for (const std::string& path : arguments.lists.at("RESULTS")) {
    const auto text = read_whole(path, kLargestResults);
    if (!text) return fail(text.error());
    auto results = parse_results(*text, path);
    if (!results) return fail(std::move(results.error()));
    files.push_back({std::move(*results), {}, {}});
    if (named) files.back().models.push_back(named);
    add_models_beside(path, files.back());
  }
  return files;
}

Result<ReportRecordings> recordings_for(const Arguments& arguments) {
  ReportRecordings recordings;
  if (arguments.has("data")) {
    if (auto added = recordings.add_named(arguments.text("data")); !added) {
      return fail(std::move(added.error()));
    }
  }
  for (const std::string& path : arguments.lists.at("RESULTS")) recordings.add_beside(path);
  return recordings;
}

Result<Report> make(const Arguments& arguments) {
  const auto threads = read_threads(arguments);
  if (!threads) return fail(threads.error());
  const auto files = read_files(arguments);
  if (!files) return fail(files.error());
  auto recordings = recordings_for(arguments);
  if (!recordings) return fail(std::move(recordings.error()));
  auto things = report_things();
  if (!things) return fail(std::move(things.error()));
  const ReportSources sources{SOMATO_VERSION,
                              [&](const std::string& hash) { return recordings->find(hash); },
                              arguments.has("data") ? arguments.text("data") : "",
                              std::move(*things),
                              explore_units(),
                              *threads};
  return make_report(*files, sources);
}

// What is found beside the results by itself.
Result<void> check_found(const Arguments& arguments) {
  for (const std::string& path : arguments.lists.at("RESULTS")) {
    std::vector<std::string> found = models_beside(path);
    for (const GivenRecordings& beside : recordings_beside(path)) {
      for (std::size_t i = 0; i < beside.count(); ++i) found.push_back(beside.path(i).string());
    }
    if (auto apart = check_not_read(arguments.text("output"), found); !apart) return apart;
  }
  return {};
}

Result<void> run_report(const Arguments& arguments) {
  const auto page = find_page();
  if (!page) return fail(page.error());
  if (auto once = check_results(arguments); !once) return once;
  if (auto apart = check_found(arguments); !apart) return apart;
  const auto report = make(arguments);
  if (!report) return fail(report.error());
  const auto whole = report_page(*page, report->json);
  if (!whole) return fail(whole.error());
  const std::string output = arguments.text("output");
  if (auto saved = save_whole(output, *whole); !saved) return saved;
  std::string text = fmt::format("{}: {}, {}\n", output, counted(report->systems, "system"),
                                 counted(report->claims, "claim"));
  for (const std::string& sentence : report->missing) text += "  " + sentence + "\n";
  print_summary(text);
  return {};
}

}  // namespace

Command report_command() {
  return {
      "report",
      "Make one page of results, to look at in a browser: maps, what their neurons stand for, "
      "what the sensors told, claims",
      {{"RESULTS", "results.json of studies and reproductions", true, true}},
      {output_flag("-o,--output", "The page to save, such as report.html", true),
       input_flag(
           "--data",
           "Recordings that the results are of, beside those in the folders of RESULTS: a file, "
           "a folder of files, a data set, or a folder of data sets"),
       input_flag("--model",
                  "A trained system, beside those in the folders of RESULTS; used for results "
                  "with its settings"),
       threads_flag()},
      {},
      run_report};
}

}  // namespace somato::program
