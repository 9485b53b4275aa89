#include "report/made_report.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/files/whole_file.h"
#include "explore/exploring_body.h"
#include "flags/output.h"
#include "recordings/layout_flag.h"
#include "report/model_files.h"
#include "report/pages.h"
#include "report/report_recordings.h"
#include "report/report_things.h"
#include "som/data.h"
#include "somato/graph/system_model.h"
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

Result<void> check_results(const std::vector<std::string>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code missing;
      if (!fs::equivalent(paths[i], paths[j], missing)) continue;
      return fail(ErrorKind::kUsage, "the file is given twice", paths[i], "name each file once");
    }
  }
  return {};
}

constexpr const char* kInferenceFile = "inference.json";

struct ReadFiles {
  std::vector<ReportFile> results;
  std::vector<ReportInference> inferences;
};

// The results in a folder that a command has written.
Result<std::string> results_path(const std::string& path) {
  std::error_code missing;
  if (!fs::is_directory(path, missing)) return path;
  for (const char* name : {kInferenceFile, "results.json"}) {
    const fs::path file = fs::path(path) / name;
    if (fs::is_regular_file(file, missing)) return file.string();
  }
  const bool is_sweep = fs::is_regular_file(fs::path(path) / "sweep.json", missing);
  return fail(ErrorKind::kData, "the folder has neither results.json nor inference.json", path,
              is_sweep ? "open sweep.svg, the picture of a sweep, or complete the inference, "
                         "'somato sweep --targets'"
                       : "name a folder of 'run', 'reproduce' or 'sweep --targets'");
}

Result<std::vector<std::string>> results_paths(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    SOMATO_TRY(auto file, results_path(path));
    files.push_back(std::move(file));
  }
  return files;
}

Result<ReadFiles> read_files(const std::vector<std::string>& paths) {
  ReadFiles files;
  for (const std::string& path : paths) {
    SOMATO_TRY(auto text, read_whole(path, kLargestResults));
    if (fs::path(path).filename() == kInferenceFile) {
      files.inferences.push_back({path, std::move(text)});
      continue;
    }
    SOMATO_TRY(auto results, parse_results(text, path));
    files.results.push_back({path, std::move(results)});
  }
  return files;
}

// The file of --model must be a trained system.
Result<std::optional<std::string>> named_model(const Arguments& arguments) {
  if (!arguments.has("model")) return std::optional<std::string>{};
  const std::string path = arguments.text("model");
  return load_system(path).map([&](const SystemModel&) { return std::optional(path); });
}

Result<ReportRecordings> recordings_for(const Arguments& arguments,
                                        const std::vector<ReportFile>& files) {
  ReportRecordings recordings;
  if (arguments.has("data")) {
    const std::string path = arguments.text("data");
    SOMATO_TRY_VOID(is_table(path) ? recordings.add_table(path, files)
                                   : recordings.add_named(path));
  }
  for (const ReportFile& file : files) recordings.add_beside(file.path);
  return recordings;
}

Result<Report> make(const Arguments& arguments, const ReadFiles& files) {
  SOMATO_TRY(const auto threads, read_threads(arguments));
  SOMATO_TRY(const auto named, named_model(arguments));
  SOMATO_TRY(auto recordings, recordings_for(arguments, files.results));
  SOMATO_TRY(const auto objects, read_objects(arguments));
  SOMATO_TRY(auto places, read_layout_flag(arguments));
  const ReportSources sources{SOMATO_VERSION,
                              [&](const std::string& hash) { return recordings.find(hash); },
                              [&](const std::string& results, const ModelFile& model) {
                                return load_model(results, model, named);
                              },
                              [&](const std::string& hash) { return recordings.path(hash); },
                              arguments.has("data") ? arguments.text("data") : "",
                              things_in(objects),
                              built_in_things(),
                              explore_units(),
                              threads,
                              std::move(places)};
  return make_report(files.results, sources, files.inferences);
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
  if (!arguments.has("output")) return {};
  for (const ReportFile& file : files) {
    std::vector<std::string> found = models_of(file);
    for (const GivenRecordings& beside : recordings_beside(file.path)) {
      for (std::size_t i = 0; i < beside.count(); ++i) found.push_back(beside.path(i).string());
    }
    SOMATO_TRY_VOID(check_not_read(arguments.text("output"), found));
  }
  return {};
}

}  // namespace

std::vector<Flag> report_source_flags() {
  return {input_flag("--data",
                     "Recordings on which the results are based, in addition to those in the "
                     "folders of RESULTS: a file, a folder of files, a data set, a folder of data "
                     "sets, or a table"),
          input_flag("--model",
                     "The trained system that RESULTS name, if it is no longer in their folder"),
          input_flag("--objects",
                     "TOML file with the objects and materials that were explored, for their "
                     "pictures and properties"),
          layout_flag("with which the page draws a skin"), threads_flag()};
}

Result<MadeReport> made_report(const Arguments& arguments, const std::vector<std::string>& paths) {
  SOMATO_TRY(const auto page, find_page());
  SOMATO_TRY(const auto found, results_paths(paths));
  SOMATO_TRY_VOID(check_results(found));
  SOMATO_TRY(const auto files, read_files(found));
  SOMATO_TRY_VOID(check_found(arguments, files.results));
  SOMATO_TRY(auto report, make(arguments, files));
  SOMATO_TRY(auto whole, report_page(page, report.json));
  return MadeReport{std::move(whole), std::move(report)};
}

}  // namespace somato::program
