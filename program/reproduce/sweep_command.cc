#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "explore/explore_table.h"
#include "flags/commands.h"
#include "flags/output.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "reproduce/sweep_run.h"
#include "reproduce/sweep_table.h"
#include "som/data.h"
#include "somato/studies/own_systems.h"
#include "studies/sweep/sweep.h"
#include "studies/sweep/sweep_picture.h"
#include "studies/sweep/sweep_results.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::map<std::string, std::string> explore_defaults() {
  std::map<std::string, std::string> defaults;
  for (const auto& [name, info] : explore_parameters()) defaults[name] = info.default_text;
  return defaults;
}

// With given recordings there is no exploration.
Result<void> check_moved(const SweepRequest& request) {
  for (const Unknown& unknown : request.sweep.sweep.unknowns) {
    for (const std::string& key : unknown.parameters.key) {
      if (!request.pairs.given || !key.starts_with("explore.")) continue;
      return fail(ErrorKind::kUsage, "'" + key + "' has no effect with --data", unknown.where,
                  "omit --data, or remove this unknown");
    }
  }
  return {};
}

Result<void> check_points(const SweepRequest& request) {
  for (const SweepPoint& point : request.points) {
    SOMATO_TRY(const auto plan, plan_of_point(request.sweep, point));
    for (const ReproductionPart& part : plan.parts) {
      auto right = check_explorable(part, request.pairs.given.has_value());
      if (!right) return right;
    }
  }
  return {};
}

Result<void> read_sweep_files(const Arguments& arguments, SweepRequest& request) {
  SOMATO_TRY(const auto file, read_toml(arguments.text("over")));
  SOMATO_TRY(const auto sweep, read_sweep(file));
  SOMATO_TRY(const auto system, read_file_or_own(arguments.text("SYSTEM")));
  SOMATO_TRY(auto planned, plan_sweep(sweep, system, explore_defaults()));
  request.sweep = std::move(planned);
  request.points = sweep_points(sweep);
  request.pairs.pairs = sweep.sweep.pairs;
  request.pairs.recordings = sweep.sweep.recordings;
  request.pairs.seed = sweep.sweep.seed;
  request.pairs.compare_folds = false;  // of every point, it would take as long as the sweep
  return check_moved(request).and_then([&] { return check_points(request); });
}

Result<SweepRequest> read_sweep_request(const Arguments& arguments) {
  SweepRequest request;
  request.out = arguments.has("out") ? arguments.text("out") : "out/sweep";
  SOMATO_TRY(auto part, read_part(arguments));
  request.part = std::move(part);
  auto read = read_threads_and_data(arguments, request.pairs).and_then([&] {
    return read_sweep_files(arguments, request);
  });
  if (!read) return fail(std::move(read.error()));
  return request;
}

Result<void> save_results(const Arguments& arguments, const SweepRequest& request,
                          const SweepResults& results) {
  const std::string path = (request.out / "sweep.json").string();
  const std::string picture = (request.out / "sweep.svg").string();
  const std::string json = to_json(results);
  SOMATO_TRY_VOID(save_whole(path, json));
  SOMATO_TRY_VOID(save_whole(picture, sweep_picture(results)));
  print_summary(arguments,
                part_text(request.part) + sweep_table(results) +
                    fmt::format("\nWritten: {}, {}\n", path, picture),
                json);
  return {};
}

Result<void> run_sweep(const Arguments& arguments) {
  SOMATO_TRY(auto request, read_sweep_request(arguments));
  SweepRun sweep(request);
  SOMATO_TRY_VOID(sweep.make_folders());
  for (const char* file : {"sweep.json", "sweep.svg"}) {
    SOMATO_TRY_VOID(check_output((request.out / file).string()));
  }
  SOMATO_TRY([[maybe_unused]] const auto lock, sweep.lock());
  if (auto ran = sweep.run(); !ran) return fail(how_to_go_on(std::move(ran.error())));
  SOMATO_TRY(const auto results, sweep.results());
  if (results.points.size() == request.points.size()) {
    return save_results(arguments, request, results);
  }
  print_part(arguments, request.part, {results.points.size(), request.points.size()}, "point",
             "sweep.json");
  return {};
}

std::vector<KeySection> key_sections_of_sweeps() {
  return {{"Files of `somato sweep`",
           "The file of `--over` ([sweeps](sweeps.md)); its other tables change the system, as a "
           "variation does.",
           {key_table<SweepParameters>("`[sweep]`"),
            key_table<UnknownParameters>("`[unknown.NAME]`")}}};
}

}  // namespace

Command sweep_command() {
  return {"sweep",
          "Run a system over a design of its unknown settings, and report where its claims hold",
          {{"SYSTEM", "TOML file of a system with claims, or a name listed by 'somato systems'",
            true, false, Role::kInput, own_file_names}},
          {input_flag("--over", "TOML file with the unknowns and the design of the points", true),
           part_flag("point"), given_recordings_flag(), test_recording_flag(),
           folder_flag("-o,--out",
                       "Folder for sweep.json, sweep.svg and the results of parts. Default: "
                       "out/sweep",
                       {"sweep.json", "sweep.svg"}),
           threads_flag(), json_flag()},
          {},
          run_sweep,
          {},
          key_sections_of_sweeps};
}

}  // namespace somato::program
