#include "reproduce/match_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/archives/checksum.h"
#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "bodies/sensors/sensor_parameters.h"
#include "flags/output_folder.h"
#include "somato/bodies/exploring.h"
#include "somato/simulation/sense.h"
#include "somato/simulation/simulated_explorer.h"
#include "studies/inference/inference_results.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

bool is_sensor_key(const std::string& key) {
  const std::string name = key.substr(key.rfind('.') + 1);
  const auto& known = sensor_parameters();
  return key.starts_with("explore.") &&
         std::any_of(known.begin(), known.end(),
                     [&](const ParameterInfo& info) { return info.name == name; });
}

bool is_of_sensors(const Unknown& unknown) {
  const auto& keys = unknown.parameters.key;
  return std::all_of(keys.begin(), keys.end(), is_sensor_key);
}

// The point with the values of the body for unknowns of sensors, which movements do not depend on.
SweepPoint movements_at(const SweepDescription& sweep, SweepPoint point) {
  for (std::size_t u = 0; u < point.size(); ++u) {
    if (is_of_sensors(sweep.unknowns[u])) point[u] = {};
  }
  return point;
}

Result<ExploreTable> table_at(const SystemSweep& sweep, const SweepPoint& point) {
  SOMATO_TRY(const auto files, files_at(sweep, point));
  const Table* explore = table_in(files.front().content, "explore");
  return read_explore_table(*explore);
}

Result<Recording> explored(const ExploreTable& table, std::uint64_t seed, std::size_t threads) {
  SOMATO_TRY(auto things, explored_things(table));
  SOMATO_TRY(const auto explorer,
             simulated_explorer(table.explore.body, things, table.exploring, seed));
  const ExploreOptions options{{.should_continue = [] { return !stop_requested(); }}};
  Recording recording;
  const auto outcome = explore_all(
      *explorer, {table.explore.explorations}, threads, options,
      [&](Exploration&& exploration) -> Result<void> {
        recording.explorations.push_back(std::move(exploration));
        return {};
      },
      [](std::uint64_t, std::uint64_t) { return !stop_requested(); });
  if (!outcome) return fail(outcome.error());
  if (!outcome->failures.empty()) return fail(outcome->failures.front().error);
  return recording;
}

// The file of objects is not among the settings.
Result<std::string> objects_text(const ExploreTable& table) {
  if (!table.explore.objects.ends_with(".toml")) return std::string();
  return read_whole(table.explore.objects);
}

std::string compared_text(const ComparedTouch& compared) {
  std::string text = compared.label;
  for (const FeaturedChannel& channel : compared.channels) {
    text += fmt::format("\n{} {} {} {}", channel.name, channel.elements, channel.is_series,
                        channel.spectrum_frames);
  }
  for (const std::string& thing : compared.things) text += "\n" + thing;
  return text;
}

// With a checksum before it.
std::string statistics_text(const std::vector<double>& statistics) {
  nlohmann::json json = nlohmann::json::array();
  for (const double value : statistics) {
    json.push_back(std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr));
  }
  const std::string text = json.dump();
  return checksum_name(text) + "\n" + text;
}

std::optional<std::vector<double>> statistics_in(const std::string& content) {
  const std::size_t line = content.find('\n');
  if (line == std::string::npos) return {};
  const std::string text = content.substr(line + 1);
  if (content.substr(0, line) != checksum_name(text)) return {};
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_array()) return {};
  std::vector<double> statistics;
  for (const auto& value : json) {
    statistics.push_back(value.is_number() ? value.get<double>()
                                           : std::numeric_limits<double>::quiet_NaN());
  }
  return statistics;
}

// The tables of the body's parameters, or those of its things.
Table tables_of(const Table& explore, bool of_things) {
  Table tables{explore.where, {}};
  for (const Table::Entry& entry : explore.entries) {
    const bool is_thing = entry.name == "object" || entry.name == "material";
    const bool is_table = !std::holds_alternative<Value>(entry.content);
    if (is_table && is_thing == of_things) tables.entries.push_back(entry);
  }
  return tables;
}

Result<void> save_tables(const std::filesystem::path& path, const Table& tables) {
  if (tables.entries.empty()) return {};
  return save_whole(path.string(), to_toml(tables));
}

Result<void> save_body(const std::filesystem::path& folder, const NamedFile& body) {
  SOMATO_TRY_VOID(make_folder(folder));
  SOMATO_TRY_VOID(save_whole((folder / (body.name + ".toml")).string(), to_toml(body.content)));
  const Table& explore = *table_in(body.content, "explore");
  SOMATO_TRY_VOID(save_tables(folder / "settings.toml", tables_of(explore, false)));
  return save_tables(folder / "objects.toml", tables_of(explore, true));
}

// Those of an earlier run.
void remove_earlier_match(const std::filesystem::path& out) {
  std::error_code missing;
  std::filesystem::remove(out / "match.json", missing);
  std::filesystem::remove_all(out / "bodies", missing);
}

}  // namespace

bool plays_sensors(const SweepDescription& sweep) {
  return std::all_of(sweep.unknowns.begin(), sweep.unknowns.end(), [](const Unknown& unknown) {
    return is_of_sensors(unknown) || !unknown.parameters.is_range();
  });
}

MatchRun::MatchRun(const MatchRequest& request)
    : request_(request),
      stock_(request.out / "recordings", request.sweep.sweep.sweep.seed, request.threads),
      kept_(parts_folder(request.out), request.part.folder_name()) {}

Result<void> MatchRun::make_folders() const {
  return make_folder(request_.out / "recordings").and_then([&] { return kept_.make_folders(); });
}

Result<void> MatchRun::run() {
  kept_.look();
  const SweepPoint unchanged(request_.sweep.sweep.unknowns.size());
  const std::uint64_t seed = request_.inference.seed;
  auto simulated = simulate(unchanged, {seed, seed});
  if (!simulated) return fail(at_point(std::move(simulated.error()), unchanged));
  SOMATO_TRY(touch_, matched_touch(request_.real, *simulated, request_.match));
  const Progress progress = terminal_progress("match " + names_of(request_.sweep));
  const Part& part = request_.part;
  for (std::size_t i = part.number - 1; i < request_.points.size(); i += part.of) {
    SOMATO_TRY_VOID(statistics_at(request_.points[i], seeds_of_draw(i)));
    if (progress(i + 1, request_.points.size())) continue;
    return fail(ErrorKind::kInterrupted, "interrupted after " + std::to_string(i + 1) + " draws");
  }
  std::error_code not_empty;
  std::filesystem::remove(kept_.unfinished(), not_empty);
  return {};
}

Result<std::size_t> MatchRun::completed() {
  kept_.look();
  std::size_t count = 0;
  for (std::size_t i = 0; i < request_.points.size(); ++i) {
    SOMATO_TRY(const auto name, name_at(request_.points[i], seeds_of_draw(i)));
    count += found(name) ? 1 : 0;
  }
  return count;
}

Result<Match> MatchRun::result() {
  remove_earlier_match(request_.out);
  MatchDraws draws{request_.sweep, request_.points, Matrix<double>(0, touch_.names.size()), {}};
  for (std::size_t i = 0; i < request_.points.size(); ++i) {
    if (plays_sensors(request_.sweep.sweep)) draws.movements.push_back(recording_of_draw(i));
    SOMATO_TRY(const auto statistics, statistics_at(request_.points[i], seeds_of_draw(i)));
    std::ranges::copy(statistics, draws.statistics.add_row().begin());
  }
  SOMATO_TRY(auto match, match_touch(touch_, std::move(draws), request_.inference));
  const SweepPoint unchanged(request_.sweep.sweep.unknowns.size());
  SOMATO_TRY(match.system, checked({unchanged}, 0));
  match.bodies = posterior_points(request_.sweep.sweep, match.inference.posterior,
                                  request_.inference.bodies, request_.inference.seed);
  SOMATO_TRY(match.fresh, checked(match.bodies, 1));
  return match;
}

MatchRun::Seeds MatchRun::seeds_of_draw(std::size_t number) const {
  const SweepParameters& sweep = request_.sweep.sweep.sweep;
  return {sweep.seed + number, sweep.seed + recording_of_draw(number)};
}

std::size_t MatchRun::recording_of_draw(std::size_t number) const {
  return number * request_.sweep.sweep.sweep.recordings / request_.points.size();
}

Result<Recording> MatchRun::simulate(const SweepPoint& point, Seeds seeds) {
  SOMATO_TRY(const auto table, table_at(request_.sweep, point));
  if (!plays_sensors(request_.sweep.sweep)) return explored(table, seeds.own, request_.threads);
  SOMATO_TRY(auto moving, table_at(request_.sweep, movements_at(request_.sweep.sweep, point)));
  moving.exploring.simulation.true_values = true;
  moving.explore.new_objects = false;
  stock_.begin_at(seeds.movements);
  SOMATO_TRY(const auto kept, stock_.get(moving, 0));
  return sense(kept->recording, table.exploring, seeds.own, request_.threads);
}

Result<std::string> MatchRun::name_at(const SweepPoint& point, Seeds seeds) const {
  SOMATO_TRY(const auto table, table_at(request_.sweep, point));
  SOMATO_TRY(const auto objects, objects_text(table));
  const std::string seeds_text =
      plays_sensors(request_.sweep.sweep)
          ? fmt::format(
                "{} played on {} {}", seeds.own, seeds.movements,
                to_text(*table_at(request_.sweep, movements_at(request_.sweep.sweep, point))))
          : fmt::format("{}", seeds.own);
  return checksum_name(fmt::format("match {}\n{}\n{}\n{}\n{}\n{}", kVersionOfBits, physics_engine(),
                                   to_text(table), objects, seeds_text,
                                   compared_text(touch_.compared)));
}

std::optional<std::vector<double>> MatchRun::found(const std::string& name) const {
  const auto content = kept_.find_text(name);
  auto statistics = content ? statistics_in(*content) : std::nullopt;
  if (statistics && statistics->size() != touch_.names.size()) return {};
  return statistics;
}

Result<std::vector<double>> MatchRun::statistics_at(const SweepPoint& point, Seeds seeds) {
  SOMATO_TRY(const auto name, name_at(point, seeds));
  if (auto statistics = found(name)) return std::move(*statistics);
  auto simulated = simulate(point, seeds);
  if (!simulated) return fail(at_point(std::move(simulated.error()), point));
  SOMATO_TRY(auto statistics, simulated_statistics(touch_, *simulated));
  SOMATO_TRY_VOID(kept_.keep_text(name, statistics_text(statistics)));
  return statistics;
}

Result<Matrix<double>> MatchRun::checked(const std::vector<SweepPoint>& points, std::size_t first) {
  const InferenceParameters& inference = request_.inference;
  Matrix<double> rows(0, touch_.names.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t pair = 0; pair < inference.pairs; ++pair) {
      const Seeds seeds{inference.seed + (first + i) * inference.pairs + pair,
                        inference.seed + pair};
      SOMATO_TRY(const auto statistics, statistics_at(points[i], seeds));
      std::ranges::copy(statistics, rows.add_row().begin());
    }
  }
  return rows;
}

Error MatchRun::at_point(Error error, const SweepPoint& point) const {
  if (error.kind == ErrorKind::kInterrupted) return error;
  error.what += " (at " + name_of_point(request_.sweep.sweep, point) + ")";
  return error;
}

Result<void> save_match(const MatchRequest& request, const Match& match) {
  SOMATO_TRY_VOID(save_whole((request.out / "match.json").string(), to_json(match)));
  const std::filesystem::path folder = request.out / "bodies";
  SOMATO_TRY_VOID(make_folder(folder));
  for (std::size_t body = 0; body < match.bodies.size(); ++body) {
    SOMATO_TRY(const auto files, files_at(request.sweep, match.bodies[body]));
    SOMATO_TRY_VOID(save_body(folder / fmt::format("{:02}", body + 1), files.front()));
  }
  return {};
}

}  // namespace somato::program
