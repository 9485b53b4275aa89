#include "views/exports/foxglove_layout.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "views/exports/scene_messages.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180.0 / std::numbers::pi;

// A column of panels of equal height.
Json column_of(const std::vector<std::string>& panels, std::size_t first = 0) {
  const std::size_t count = panels.size() - first;
  if (count == 1) return panels[first];
  return {{"direction", "column"},
          {"splitPercentage", 100.0 / static_cast<double>(count)},
          {"first", panels[first]},
          {"second", column_of(panels, first + 1)}};
}

Json plot_of(const PlottedTopic& plotted) {
  Json paths = Json::array();
  for (std::size_t i = 0; i < plotted.element_names.size(); ++i) {
    paths.push_back({{"value", fmt::format("{}.{}[{}]", plotted.topic, plotted.field, i)},
                     {"enabled", true},
                     {"timestampMethod", "receiveTime"},
                     {"label", plotted.element_names[i]}});
  }
  return {{"title", plotted.title},  {"paths", paths},          {"showXAxisLabels", true},
          {"showYAxisLabels", true}, {"showLegend", true},      {"legendDisplay", "floating"},
          {"isSynced", true},        {"xAxisVal", "timestamp"}, {"sidebarDimension", 240}};
}

// The camera looks along an axis that is `phi` away from that which points up.
Json camera_of(const ShownScene& scene) {
  const double x = scene.camera[0] - scene.target[0];
  const double y = scene.camera[1] - scene.target[1];
  const double z = scene.camera[2] - scene.target[2];
  const double distance = std::sqrt(x * x + y * y + z * z);
  return {{"perspective", true},
          {"distance", distance},
          {"phi", distance > 0.0 ? std::acos(z / distance) * kDegrees : 0.0},
          {"thetaOffset", std::atan2(x, -y) * kDegrees},
          {"target", {0, 0, 0}},
          {"targetOffset", scene.target},
          {"targetOrientation", {0, 0, 0, 1}},
          {"fovy", 45},
          {"near", 0.005},
          {"far", 100}};
}

Json scene_panel(const ShownScene& scene) {
  Json topics = Json::object();
  for (const std::string& topic : scene.topics) topics[topic] = {{"visible", true}};
  if (!scene.points.empty()) {
    topics[scene.points] = {{"visible", false},        {"colorField", "value"},
                            {"colorMode", "colormap"}, {"colorMap", "turbo"},
                            {"minValue", 0},           {"maxValue", scene.largest},
                            {"pointSize", 8}};
  }
  return {{"cameraState", camera_of(scene)}, {"followMode", "follow-pose"},
          {"followTf", kWorldFrame},         {"scene", {{"transforms", {{"visible", false}}}}},
          {"transforms", Json::object()},    {"topics", topics},
          {"layers", Json::object()}};
}

}  // namespace

std::string foxglove_layout(const std::vector<PlottedTopic>& plots, const std::string& label,
                            const std::optional<ShownScene>& scene) {
  Json panels = Json::object();
  std::vector<std::string> column;
  for (const PlottedTopic& plotted : plots) {
    column.push_back(fmt::format("Plot!{}", column.size() + 1));
    panels[column.back()] = plot_of(plotted);
  }
  if (!label.empty()) {
    column.push_back(fmt::format("RawMessages!{}", column.size() + 1));
    panels[column.back()] = {{"topicPath", label + ".data"}, {"diffEnabled", false}};
  }
  Json layout = column_of(column);
  if (scene) {
    panels["3D!1"] = scene_panel(*scene);
    layout = {{"direction", "row"},
              {"splitPercentage", 60},
              {"first", "3D!1"},
              {"second", std::move(layout)}};
  }
  return Json{{"configById", panels},
              {"globalVariables", Json::object()},
              {"userNodes", Json::object()},
              {"playbackConfig", {{"speed", 1}}},
              {"layout", layout}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace somato
