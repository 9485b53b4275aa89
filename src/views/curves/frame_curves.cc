#include "views/curves/frame_curves.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "somato/studies/alteration.h"
#include "somato/studies/study_parameters.h"
#include "views/curves/curve_point.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAltered = "altered.";
constexpr const char* kShare = "first";

// The share of the frames, if nothing else is altered.
std::optional<double> share_in(const Settings& settings) {
  std::optional<double> share;
  for (const Setting& setting : settings.settings) {
    const auto declared = Alteration::declarations().find(setting.name);
    if (!declared || setting.value == declared->info.default_text) continue;
    if (setting.name != kShare) return {};
    share = number_in(setting.value);
  }
  return share;
}

// The name of the metric by the share of the frames.
std::map<double, std::string> metrics_by_share(const PartResults& part) {
  std::map<double, std::string> metrics{{1.0, "accuracy"}};
  for (const Settings& settings : part.parameters) {
    if (!settings.part.starts_with(kAltered)) continue;
    if (const auto share = share_in(settings)) metrics[*share] = settings.part + ".accuracy";
  }
  return metrics;
}

Json points_json(const PartResults& part, const ProtocolResults& protocol) {
  Json points = Json::array();
  for (const auto& [share, name] : metrics_by_share(part)) {
    const Metric* metric = protocol.find_metric(name);
    if (metric) points.push_back(point_json(share, *metric));
  }
  return points;
}

Json empty_curve(const ProtocolResults& protocol) {
  const std::string group = protocol.group.empty() ? "" : ", " + protocol.group;
  return {{"title", "accuracy by share of the frames (" + protocol.protocol + group + ")"},
          {"x", "share of the frames"},
          {"unit", ""},
          {"metric", "accuracy"},
          {"lines", Json::array()}};
}

std::size_t most_points(const Json& curve) {
  std::size_t most = 0;
  for (const Json& line : curve["lines"]) most = std::max(most, line["points"].size());
  return most;
}

}  // namespace

Json frame_curves_json(const std::vector<const PartResults*>& parts) {
  std::map<std::tuple<std::string, std::string, std::string>, Json> curves;
  for (const PartResults* part : parts) {
    if (!part->variation.empty()) continue;
    for (const ProtocolResults& protocol : part->protocols) {
      if (protocol.protocol == choice_name(Protocol::kTrainIsTest)) continue;
      Json points = points_json(*part, protocol);
      if (points.size() < 2) continue;
      Json& curve = curves[{part->question, protocol.protocol, protocol.group}];
      if (curve.is_null()) curve = empty_curve(protocol);
      curve["lines"].push_back({{"name", part->system}, {"points", std::move(points)}});
    }
  }
  Json json = Json::array();
  for (auto& [key, curve] : curves) {
    if (most_points(curve) >= kFewestPoints) json.push_back(std::move(curve));
  }
  return json;
}

}  // namespace somato::detail
