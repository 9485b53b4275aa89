#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "explore/explore_table.h"
#include "flags/commands.h"
#include "flags/output.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "reproduce/inference_run.h"
#include "reproduce/match_run.h"
#include "reproduce/result_tables.h"
#include "reproduce/sweep_run.h"
#include "som/data.h"
#include "somato/studies/own_systems.h"
#include "studies/sweep/sweep.h"
#include "studies/sweep/sweep_picture.h"
#include "studies/sweep/sweep_results.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// With given recordings there is no exploration.
Result<void> check_moved(const SweepRequest& request) {
  if (request.pairs.given && request.sweep.sweep.sweep.stock) {
    return fail(ErrorKind::kUsage, "a sweep with a stock explores", "--data",
                "omit it, or remove 'stock'");
  }
  SOMATO_TRY_VOID(check_stock(request.sweep.sweep));
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

Result<void> read_target_file(const Arguments& arguments, SweepRequest& request) {
  if (!arguments.has("targets")) return {};
  if (request.pairs.given) {
    return fail(ErrorKind::kUsage, "an inference explores, for each draw and each fresh setting",
                "--targets", "omit --data");
  }
  SOMATO_TRY(const auto file, read_toml(arguments.text("targets")));
  SOMATO_TRY(auto targets, read_targets(file));
  SOMATO_TRY_VOID(add_targets(targets, request.sweep));
  const std::optional<std::size_t>& stock = request.sweep.sweep.sweep.stock;
  if (stock && *stock < targets.inference.pairs) {
    return fail(ErrorKind::kUsage,
                fmt::format("a fresh setting has {} pairs, but the stock has {} recordings",
                            targets.inference.pairs, *stock),
                arguments.text("targets"), "increase 'stock', or reduce 'pairs' in [inference]");
  }
  request.targets = std::move(targets);
  return {};
}

Result<void> read_sweep_files(const Arguments& arguments, SweepRequest& request) {
  SOMATO_TRY(const auto file, read_toml(arguments.text("over")));
  SOMATO_TRY(const auto sweep, read_sweep(file));
  std::vector<NamedFile> systems;
  for (const std::string& name : arguments.lists.at("SYSTEM")) {
    SOMATO_TRY(auto system, read_file_or_own(name));
    systems.push_back(std::move(system));
  }
  SOMATO_TRY(auto planned, plan_sweep(sweep, systems, explore_defaults()));
  request.sweep = std::move(planned);
  SOMATO_TRY_VOID(read_target_file(arguments, request));
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

// Nothing without targets.
Result<std::optional<InferenceResults>> inferred_from(const SweepRequest& request,
                                                      const SweepResults& results) {
  if (!request.targets) return std::optional<InferenceResults>{};
  SOMATO_TRY(auto inferred, run_inference(request, results));
  SOMATO_TRY_VOID(save_inference(request, inferred));
  return std::optional(std::move(inferred));
}

Result<void> save_results(const Arguments& arguments, const SweepRequest& request,
                          const SweepResults& results) {
  const std::string path = (request.out / "sweep.json").string();
  const std::string picture = (request.out / "sweep.svg").string();
  const std::string json = to_json(results);
  SOMATO_TRY_VOID(save_whole(path, json));
  SOMATO_TRY_VOID(save_whole(picture, sweep_picture(results)));
  auto inferred = inferred_from(request, results);
  if (!inferred) return fail(how_to_go_on(std::move(inferred.error())));
  const std::string written = fmt::format("\nWritten: {}, {}", path, picture);
  if (*inferred) {
    print_summary(arguments,
                  part_text(request.part) + inference_table(**inferred) + written +
                      fmt::format(", {}\n", (request.out / "inference.json").string()),
                  to_json(**inferred));
    return {};
  }
  print_summary(arguments, part_text(request.part) + sweep_table(results) + written + "\n", json);
  return {};
}

Result<void> run_sweep(const Arguments& arguments) {
  if (arguments.has("match")) return run_match(arguments);
  SOMATO_TRY(auto request, read_sweep_request(arguments));
  SweepRun sweep(request);
  SOMATO_TRY_VOID(sweep.make_folders());
  for (const char* file : {"sweep.json", "sweep.svg"}) {
    SOMATO_TRY_VOID(check_output((request.out / file).string()));
  }
  if (request.targets) SOMATO_TRY_VOID(check_output((request.out / "inference.json").string()));
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
  return {
      {"Files of `somato sweep`",
       "The file of `--over` ([sweeps](sweeps.md)); its other tables change the system, as a "
       "variation does.",
       {key_table<SweepParameters>("`[sweep]`"), key_table<UnknownParameters>("`[unknown.NAME]`"),
        key_table<InferenceParameters>("`[inference]`",
                                       "The file of `--targets` ([inference](inference.md))."),
        key_table<Target>("`[[target]]`"),
        key_table<MatchParameters>("`[match]`",
                                   "With `--match` in the file of `--over`, with `[inference]` "
                                   "([fitting a body](../match.md)).")}}};
}

}  // namespace

Command sweep_command() {
  return {
      "sweep",
      "Run systems over a design of their unknown settings, and report where their claims hold",
      {{"SYSTEM",
        "TOML file of a system with claims, or a name listed by 'somato systems'; several "
        "systems on the same body share each point. With --match, a body or a file with a table "
        "[explore]",
        true, true, Role::kInput, own_file_names}},
      {input_flag("--over", "TOML file with the unknowns and the design of the points", true),
       input_flag("--targets",
                  "TOML file with observed values, from which the unknowns are inferred: the "
                  "points are draws from a prior, and the nearest are accepted"),
       input_flag(
           "--match",
           "Recording of a real hand or probe, to which the settings of the body are fitted: "
           "the points are draws from a prior, and those whose recordings have the most "
           "similar statistics are accepted"),
       part_flag("point"), given_recordings_flag(), test_recording_flag(),
       folder_flag(
           "-o,--out",
           "Folder for sweep.json, sweep.svg, inference.json, match.json and the results of parts. "
           "Default: out/sweep",
           {"sweep.json", "sweep.svg", "inference.json", "match.json"}),
       threads_flag(), json_flag()},
      {},
      run_sweep,
      {},
      key_sections_of_sweeps};
}

}  // namespace somato::program
