#include "views/curves/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "somato/graph/module.h"
#include "views/curves/curve_point.h"
#include "views/curves/part_settings.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

// Which metric, under which protocol.
struct Measure {
  std::string metric;
  std::string protocol;
  std::string group;

  auto operator<=>(const Measure&) const = default;
};

// A setting that parts differ in: its name, and the parts of the settings where it stands.
struct Differing {
  std::vector<std::string> places;
  std::string name;

  auto operator<=>(const Differing&) const = default;
};

struct Point {
  double x = 0.0;
  const PartResults* part = nullptr;
};

struct Line {
  std::string system;
  std::vector<Point> points;
};

using Flat = std::map<std::pair<std::string, std::string>, std::string>;

// All but what only says how often.
Flat flattened(const std::vector<Settings>& settings) {
  static const std::set<std::string> how_often{"seeds", "first_seed", "protocols", "groups"};
  Flat flat;
  for (const Settings& part : settings) {
    for (const Setting& setting : part.settings) {
      if (part.part == "study" && how_often.contains(setting.name)) continue;
      flat[{part.part, setting.name}] = setting.value;
    }
  }
  return flat;
}

// The number that stands at all of these places, if it is one.
std::optional<double> number_at(const Flat& flat, const Differing& differing) {
  std::optional<double> number;
  for (const std::string& place : differing.places) {
    const auto found = number_in(flat.at({place, differing.name}));
    if (!found || (number && *number != *found)) return {};
    number = found;
  }
  return number;
}

// By default a schedule ends with training.
bool follows_iterations(const Flat& flat, const std::pair<std::string, std::string>& key) {
  const auto iterations = flat.find({key.first, "iterations"});
  return key.second.ends_with("_reached_at") && iterations != flat.end() &&
         iterations->second == flat.at(key);
}

// In what two parts differ, if that is one setting that both have.
std::optional<Differing> difference(const Flat& a, const Flat& b) {
  if (a.size() != b.size()) return {};
  Differing differing;
  for (const auto& [key, value] : a) {
    const auto other = b.find(key);
    if (other == b.end()) return {};
    if (other->second == value) continue;
    if (follows_iterations(a, key) && follows_iterations(b, key)) continue;
    if (!differing.places.empty() && differing.name != key.second) return {};
    differing.places.push_back(key.first);
    differing.name = key.second;
  }
  if (differing.places.empty()) return {};
  return differing;
}

// By the setting: the base and the parts that differ from it in that one.
std::map<Differing, Line> lines_of(const std::vector<const PartResults*>& parts) {
  std::map<Differing, Line> lines;
  const PartResults& base = *parts.front();
  const Flat flat = flattened(base.parameters);
  for (const PartResults* other : parts) {
    const Flat others = flattened(other->parameters);
    const auto differing = difference(flat, others);
    const auto x = differing ? number_at(others, *differing) : std::nullopt;
    const auto base_x = differing ? number_at(flat, *differing) : std::nullopt;
    if (!x || !base_x) continue;
    Line& line = lines[*differing];
    if (line.points.empty()) line = {base.system, {{*base_x, &base}}};
    const bool is_new = std::none_of(line.points.begin(), line.points.end(),
                                     [&](const Point& point) { return point.x == *x; });
    if (is_new) line.points.push_back({*x, other});
  }
  return lines;
}

const Metric* find_metric(const PartResults& part, const Measure& measure) {
  for (const ProtocolResults& protocol : part.protocols) {
    if (protocol.protocol != measure.protocol || protocol.group != measure.group) continue;
    return protocol.find_metric(measure.metric);
  }
  return nullptr;
}

Json line_json(const Line& line, const Measure& measure) {
  Json points = Json::array();
  for (const Point& point : line.points) {
    const Metric* metric = find_metric(*point.part, measure);
    if (metric) points.push_back(point_json(point.x, *metric));
  }
  return {{"name", line.system}, {"points", std::move(points)}};
}

std::string unit_of(const Differing& differing, const PartResults& part,
                    const std::map<std::string, std::string>& units) {
  const auto known = units.find(differing.places.front() + "." + differing.name);
  if (known != units.end()) return known->second;
  const Settings* settings = find_part(part.parameters, differing.places.front());
  const ModuleType* type = settings ? type_of(*settings) : nullptr;
  for (const ParameterInfo& info : type ? type->parameters : std::vector<ParameterInfo>{}) {
    if (info.name == differing.name) return info.unit;
  }
  return {};
}

std::string title_of(const Differing& differing, const Measure& measure) {
  return fmt::format("{} by {} of {} ({}{})", measure.metric, differing.name,
                     fmt::join(differing.places, ", "), measure.protocol,
                     measure.group.empty() ? "" : ", " + measure.group);
}

Json curve_json(const Differing& differing, const std::vector<Line>& lines, const Measure& measure,
                const std::map<std::string, std::string>& units) {
  Json drawn = Json::array();
  std::size_t most = 0;
  for (const Line& line : lines) {
    Json json = line_json(line, measure);
    most = std::max(most, json["points"].size());
    if (json["points"].size() > 1) drawn.push_back(std::move(json));
  }
  if (most < kFewestPoints) return nullptr;
  return {{"title", title_of(differing, measure)},
          {"x", differing.name},
          {"unit", unit_of(differing, *lines.front().points.front().part, units)},
          {"metric", measure.metric},
          {"lines", std::move(drawn)}};
}

// Accuracy first, then what is claimed.
std::vector<Measure> measures_for(const std::vector<Line>& lines,
                                  const std::vector<const ClaimOutcome*>& claims) {
  std::vector<Measure> all;
  const auto add = [&](Measure measure) {
    if (std::find(all.begin(), all.end(), measure) == all.end()) all.push_back(std::move(measure));
  };
  const PartResults& first = *lines.front().points.front().part;
  for (const ProtocolResults& protocol : first.protocols) {
    if (protocol.find_metric("accuracy")) add({"accuracy", protocol.protocol, protocol.group});
  }
  for (const ClaimOutcome* outcome : claims) {
    const Claim& claim = outcome->claim;
    const bool about = claim.question == first.question &&
                       std::any_of(lines.begin(), lines.end(),
                                   [&](const Line& line) { return line.system == claim.system; });
    if (about) add({claim.metric, claim.protocol, claim.group});
  }
  return all;
}

using Groups =
    std::vector<std::pair<std::pair<std::string, std::string>, std::vector<const PartResults*>>>;

// Parts of a system under one question, as it stands first.
Groups grouped(const std::vector<const PartResults*>& parts) {
  Groups groups;
  for (const PartResults* part : parts) {
    const std::pair key{part->question, part->system};
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& one) { return one.first == key; });
    if (group == groups.end()) group = groups.insert(groups.end(), {key, {}});
    const bool first = part->variation.empty() && !group->second.empty() &&
                       !group->second.front()->variation.empty();
    group->second.insert(first ? group->second.begin() : group->second.end(), part);
  }
  return groups;
}

}  // namespace

Json curves_json(const std::vector<const PartResults*>& parts,
                 const std::vector<const ClaimOutcome*>& claims,
                 const std::map<std::string, std::string>& units) {
  std::map<std::pair<std::string, Differing>, std::vector<Line>> curves;
  for (const auto& [key, members] : grouped(parts)) {
    for (auto& [differing, line] : lines_of(members)) {
      std::sort(line.points.begin(), line.points.end(),
                [](const Point& a, const Point& b) { return a.x < b.x; });
      curves[{key.first, differing}].push_back(std::move(line));
    }
  }
  Json json = Json::array();
  for (const auto& [key, lines] : curves) {
    for (const Measure& measure : measures_for(lines, claims)) {
      Json curve = curve_json(key.second, lines, measure, units);
      if (!curve.is_null()) json.push_back(std::move(curve));
    }
  }
  return json;
}

}  // namespace somato::detail
