#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "flags/layout_flag.h"
#include "flags/output.h"
#include "report/model_files.h"
#include "report/pages.h"
#include "report/report_recordings.h"
#include "report/report_things.h"
#include "som/data.h"
#include "somato/graph/system_model.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "version.h"
#include "views/report/report.h"
#include "views/report/results_file.h"

namespace somato::program {
namespace {

namespace fs = std::filesystem;

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
      return fail(ErrorKind::kUsage, "the file is given twice", paths[i], "name each file once");
    }
  }
  return {};
}

Result<std::vector<ReportFile>> read_files(const Arguments& arguments) {
  std::vector<ReportFile> files;
  for (const std::string& path : arguments.lists.at("RESULTS")) {
    SOMATO_TRY(const auto text, read_whole(path, kLargestResults));
    SOMATO_TRY(auto results, parse_results(text, path));
    files.push_back({path, std::move(results)});
  }
  return files;
}

// The file of --model must be a trained system.
Result<std::optional<std::string>> named_model(const Arguments& arguments) {
  if (!arguments.has("model")) return std::optional<std::string>{};
  const std::string path = arguments.text("model");
  return load_system(path).map([&](const SystemModel&) { return std::optional(path); });
}

Result<ReportRecordings> recordings_for(const Arguments& arguments) {
  ReportRecordings recordings;
  if (arguments.has("data")) {
    SOMATO_TRY_VOID(recordings.add_named(arguments.text("data")));
  }
  for (const std::string& path : arguments.lists.at("RESULTS")) recordings.add_beside(path);
  return recordings;
}

Result<Report> make(const Arguments& arguments, const std::vector<ReportFile>& files) {
  SOMATO_TRY(const auto threads, read_threads(arguments));
  SOMATO_TRY(const auto named, named_model(arguments));
  SOMATO_TRY(auto recordings, recordings_for(arguments));
  SOMATO_TRY(auto things, report_things());
  SOMATO_TRY(auto places, read_layout_flag(arguments));
  const ReportSources sources{SOMATO_VERSION,
                              [&](const std::string& hash) { return recordings.find(hash); },
                              [&](const std::string& results, const ModelFile& model) {
                                return load_model(results, model, named);
                              },
                              arguments.has("data") ? arguments.text("data") : "",
                              std::move(things),
                              explore_units(),
                              threads,
                              std::move(places)};
  return make_report(files, sources);
}

std::vector<std::string> models_of(const ReportFile& file) {
  std::vector<std::string> paths;
  for (const PartResults& part : file.results.parts) {
    if (part.model) paths.push_back(model_path(file.path, *part.model).string());
  }
  return paths;
}

// Files that are found automatically in the folders of the results.
Result<void> check_found(const Arguments& arguments, const std::vector<ReportFile>& files) {
  for (const ReportFile& file : files) {
    std::vector<std::string> found = models_of(file);
    for (const GivenRecordings& beside : recordings_beside(file.path)) {
      for (std::size_t i = 0; i < beside.count(); ++i) found.push_back(beside.path(i).string());
    }
    SOMATO_TRY_VOID(check_not_read(arguments.text("output"), found));
  }
  return {};
}

Result<void> run_report(const Arguments& arguments) {
  SOMATO_TRY(const auto page, find_page());
  SOMATO_TRY_VOID(check_results(arguments));
  SOMATO_TRY(const auto files, read_files(arguments));
  SOMATO_TRY_VOID(check_found(arguments, files));
  SOMATO_TRY(const auto report, make(arguments, files));
  SOMATO_TRY(const auto whole, report_page(page, report.json));
  const std::string output = arguments.text("output");
  SOMATO_TRY_VOID(save_whole(output, whole));
  std::string text = fmt::format("{}: {}, {}\n", output, counted(report.systems, "system"),
                                 counted(report.claims, "claim"));
  for (const std::string& sentence : report.missing) text += "  " + sentence + "\n";
  print_summary(text);
  return {};
}

}  // namespace

Command report_command() {
  return {
      "report",
      "Make one page of results for a browser: maps, the classes of their neurons, sensor readings "
      "and claims",
      {{"RESULTS", "results.json of studies and reproductions", true, true}},
      {output_flag("-o,--output", "File for the page, such as report.html", true),
       input_flag("--data",
                  "Recordings on which the results are based, in addition to those in the folders "
                  "of RESULTS: a file, a folder of files, a data set, or a folder of data sets"),
       input_flag("--model",
                  "The trained system that RESULTS name, if it is no longer in their folder"),
       layout_flag("with which the page draws a skin"), threads_flag()},
      {},
      run_report};
}

}  // namespace somato::program
