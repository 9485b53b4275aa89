#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/core/contains.h"
#include "base/files/toml_file.h"
#include "flags/output.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "reproduce/match_run.h"
#include "reproduce/result_tables.h"
#include "som/data.h"
#include "somato/simulation/simulated_explorer.h"
#include "studies/inference/inference_results.h"
#include "studies/inference/match_predictors.h"
#include "studies/sweep/sweep_points.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// The table of a file, which is taken out of it.
template <typename Parameters>
Result<Parameters> taken_table(Table& file, const std::string& name) {
  const Table::Entry* entry = file.find(name);
  if (!entry) return Parameters{};
  const auto* table = std::get_if<Table>(&entry->content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'" + name + "' must be a table", entry->where,
                "write [" + name + "] on a separate line");
  }
  auto read = read_parameters<Parameters>(*table);
  std::erase_if(file.entries, [&](const Table::Entry& one) { return one.name == name; });
  return read;
}

Result<void> check_match_flags(const Arguments& arguments) {
  for (const char* flag : {"targets", "data", "test-data"}) {
    if (!arguments.has(flag)) continue;
    return fail(ErrorKind::kUsage, fmt::format("--{} has no effect with --match", flag),
                fmt::format("--{}", flag), "omit one of them");
  }
  if (arguments.lists.at("SYSTEM").size() == 1) return {};
  return fail(ErrorKind::kUsage, "one body is fitted to a recording", "SYSTEM",
              "name one system or body");
}

// Every draw has one recording.
Result<void> check_pairs(const Table& file, const SweepDescription& sweep) {
  const Table* table = table_in(file, "sweep");
  const Table::Entry* pairs = table ? table->find("pairs") : nullptr;
  if (pairs) {
    return fail(ErrorKind::kUsage, "'pairs' has no effect with --match", pairs->where,
                "remove it: each draw has one recording");
  }
  const Table::Entry* recordings = table ? table->find("recordings") : nullptr;
  if (!recordings || plays_sensors(sweep)) return {};
  return fail(ErrorKind::kUsage, "'recordings' has no effect, because each draw explores",
              recordings->where,
              "remove it; sensors are played if all other unknowns have lists of values");
}

bool is_body(const std::string& name) {
  return choice_named<ExploringBody>("body", name, "").has_value();
}

Table file_of_body(const std::string& name) {
  Table explore{name, {{"body", name, Value{name}}}};
  return {name, {{"explore", name, std::move(explore)}}};
}

// A file of a system, a built-in one, or a body.
Result<NamedFile> read_body_file(const std::string& name) {
  auto file = read_file_or_own(name);
  if (!file && is_body(name)) return NamedFile{name, file_of_body(name), {}};
  if (!file) return file;
  if (table_in(file->content, "explore")) return file;
  return fail(ErrorKind::kUsage, "'" + name + "' does not define an exploration",
              file->content.where, "add a table [explore], or name a body such as lucs2");
}

Result<void> check_unknowns(const SweepDescription& sweep) {
  for (const Unknown& unknown : sweep.unknowns) {
    for (const std::string& key : unknown.parameters.key) {
      if (key.starts_with("explore.")) continue;
      return fail(ErrorKind::kUsage, "'" + key + "' has no effect with --match", unknown.where,
                  "use settings of the exploration, explore.TABLE.NAME");
    }
  }
  for (const Table::Entry& entry : sweep.changes.entries) {
    if (entry.name == "explore") continue;
    return fail(ErrorKind::kUsage, "the table '" + entry.name + "' has no effect with --match",
                entry.where, "remove it; [explore] and its tables change the body");
  }
  return {};
}

Result<void> check_tables(const MatchRequest& request) {
  for (const SweepPoint& point : request.points) {
    SOMATO_TRY(const auto files, files_at(request.sweep, point));
    auto table = read_explore_table(*table_in(files.front().content, "explore"));
    if (!table) return fail(std::move(table.error()));
  }
  return {};
}

Result<void> read_match_files(const Arguments& arguments, MatchRequest& request) {
  const std::string over = arguments.text("over");
  SOMATO_TRY(auto file, read_toml(over));
  SOMATO_TRY(request.inference, taken_table<InferenceParameters>(file, "inference"));
  SOMATO_TRY(request.match, taken_table<MatchParameters>(file, "match"));
  SOMATO_TRY(const auto sweep, read_sweep(file));
  SOMATO_TRY_VOID(check_pairs(file, sweep));
  SOMATO_TRY_VOID(check_unknowns(sweep));
  const InferenceParameters& inference = request.inference;
  const std::size_t points = sweep.sweep.points.value_or(0);
  SOMATO_TRY_VOID(check_inferable(inference, sweep.sweep, std::max(points, sweep.sweep.recordings),
                                  (inference.bodies + 1) * inference.pairs, over));
  SOMATO_TRY(auto body, read_body_file(arguments.lists.at("SYSTEM").front()));
  body.name = std::filesystem::path(body.name).stem().string();
  SOMATO_TRY(request.sweep, plan_body_sweep(sweep, body, explore_defaults()));
  request.points = sweep_points(sweep);
  SOMATO_TRY(request.real, read_study_data({}, arguments.text("match")));
  return check_tables(request);
}

Result<MatchRequest> read_match_request(const Arguments& arguments) {
  MatchRequest request;
  SOMATO_TRY_VOID(check_match_flags(arguments));
  request.out = arguments.has("out") ? arguments.text("out") : "out/sweep";
  SOMATO_TRY(request.part, read_part(arguments));
  SOMATO_TRY(request.threads, read_threads(arguments));
  SOMATO_TRY_VOID(read_match_files(arguments, request));
  return request;
}

std::string compared_lines(const ComparedTouch& compared) {
  std::string text = "Channels:";
  for (const FeaturedChannel& channel : compared.channels) text += " " + printable(channel.name);
  text += "\n";
  for (const IgnoredChannel& channel : compared.ignored) {
    text += fmt::format("Not compared: {}, because {}\n", printable(channel.name),
                        printable(channel.reason));
  }
  if (compared.things.empty()) return text + "All explorations are compared together.\n";
  text += fmt::format("Compared one by one, by the label '{}':", printable(compared.label));
  for (const std::string& thing : compared.things) text += " " + printable(thing);
  return text + "\n";
}

std::string distance_line(const std::string& what, const TouchDistance& distance) {
  return fmt::format("  {:>8.2f}  {:>8.2f}  {:>6.0f} %  {}\n", distance.median,
                     distance.root_mean_square, 100.0 * distance.within_two, what);
}

std::string distance_lines(const Match& match) {
  return fmt::format(
             "\nDistance from the {} that were held out, in units of the scales of the recording\n"
             "  {:>8}  {:>8}  {:>8}\n",
             counted(match.touch.held_out_explorations, "exploration"), "median", "r.m.s.",
             "below 2") +
         distance_line("the body before, with fresh seeds", mean_distance(match, match.system)) +
         distance_line("the body after: " + counted(match.bodies.size(), "setting") +
                           " of the posterior, with fresh seeds",
                       mean_distance(match, match.fresh)) +
         distance_line("the recording: its first half", match.by_chance);
}

std::size_t without_scale(const Match& match) {
  return static_cast<std::size_t>(
      std::count_if(match.touch.scales.begin(), match.touch.scales.end(),
                    [](double scale) { return !std::isfinite(scale); }));
}

std::string advice_lines(const Match& match) {
  std::string text;
  if (2 * without_scale(match) > match.left_out.size()) {
    text += "Most statistics have no scale: explore each thing at least four times.\n";
  }
  const auto& movements = match.draws.movements;
  if (!movements.empty() && movements.front() == movements.back()) {
    text +=
        "All draws play the same movements, whose effect on the statistics is therefore not known: "
        "choose several 'recordings' in [sweep].\n";
  }
  if (!match.not_adjusted.empty())
    text += "The settings are not adjusted: " + printable(match.not_adjusted) + ".\n";
  return text;
}

std::string statistics_line(const Match& match) {
  const auto informative = static_cast<std::size_t>(
      std::count_if(match.explained.begin(), match.explained.end(),
                    [](double share) { return share >= kLeastExplained; }));
  const auto left_out = static_cast<std::size_t>(
      std::count_if(match.left_out.begin(), match.left_out.end(),
                    [](const std::string& reason) { return !reason.empty(); }));
  const auto unreached = static_cast<std::size_t>(
      std::count(match.out_of_reach.begin(), match.out_of_reach.end(), true));
  return fmt::format(
      "{}: {} used, {} left out; {} that no draw reaches; {} that the unknowns change\n",
      counted(match.left_out.size(), "statistic"), match.left_out.size() - left_out, left_out,
      unreached, informative);
}

std::string match_table(const Match& match) {
  const SystemSweep& sweep = match.draws.sweep;
  return fmt::format("{}: {}, of which the nearest {} are accepted; fitted to {}\n",
                     printable(names_of(sweep)), counted(match.draws.points.size(), "draw"),
                     match.inference.posterior.size(),
                     counted(match.touch.fitted_explorations, "exploration")) +
         compared_lines(match.touch.compared) + statistics_line(match) + advice_lines(match) +
         distance_lines(match) + "\n" +
         inferred_unknowns_table(sweep.sweep, match.inference, false);
}

Result<void> finish_match(const Arguments& arguments, const MatchRequest& request, MatchRun& run) {
  SOMATO_TRY(const auto match, run.result());
  SOMATO_TRY_VOID(save_match(request, match));
  print_summary(arguments,
                part_text(request.part) + match_table(match) +
                    fmt::format("\nWritten: {}, {}\n", (request.out / "match.json").string(),
                                (request.out / "bodies").string()),
                to_json(match));
  return {};
}

}  // namespace

Result<void> run_match(const Arguments& arguments) {
  SOMATO_TRY(const auto request, read_match_request(arguments));
  MatchRun run(request);
  SOMATO_TRY_VOID(run.make_folders());
  SOMATO_TRY_VOID(check_output((request.out / "match.json").string()));
  SOMATO_TRY([[maybe_unused]] const auto lock, run.lock());
  if (auto ran = run.run(); !ran) return fail(how_to_go_on(std::move(ran.error())));
  SOMATO_TRY(const auto completed, run.completed());
  if (completed == request.points.size()) {
    auto finished = finish_match(arguments, request, run);
    if (!finished) return fail(how_to_go_on(std::move(finished.error())));
    return {};
  }
  print_part(arguments, request.part, {completed, request.points.size()}, "draw", "match.json");
  return {};
}

}  // namespace somato::program
