#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// A topic with numbers to be plotted.
struct PlottedTopic {
  std::string topic;
  std::string field;  ///< The array with the numbers, such as `position` or `data`.
  std::string title;
  std::vector<std::string> element_names;  ///< One per element that is plotted.
};

/// The topics of a scene and its view.
struct ShownScene {
  std::vector<std::string> topics;
  std::string points;              ///< Topic of a point cloud with the field `value`, or empty.
  float largest = 1.0F;            ///< The value with the strongest colour.
  std::array<double, 3> camera{};  ///< m, as in Scene.
  std::array<double, 3> target{};
};

/// The number of elements of a topic that are plotted.
inline constexpr std::size_t kMostPlotted = 16;

/// A layout for Foxglove in JSON: the scene, if there is one, beside a plot of each topic and the
/// text of the topic `label`, unless that is empty. Source: the files that Foxglove exports.
std::string foxglove_layout(const std::vector<PlottedTopic>& plots, const std::string& label,
                            const std::optional<ShownScene>& scene);

}  // namespace somato
