#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/explorer.h"
#include "somato/bodies/scene.h"
#include "somato/graph/system_model.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"
#include "views/session/system_reading.h"

namespace somato::live {

using Json = nlohmann::ordered_json;

/// The parts of the messages to a page (docs/formats/view.md), each as JSON.
Json thing_json(const ExploredThing& thing);
Json graph_json(const System& system, const std::string& map);
Json maps_json(const System& system, const std::optional<SystemAnswer>& answer);
Json scene_json(const Scene& scene);

/// A moment of an exploration, in the words of a page.
struct ShownMoment {
  std::size_t exploration = 0;
  std::size_t frame = 0;
  std::optional<std::size_t> frames;
  double time = 0.0;
  bool last = false;
  /// The values of each channel, with NaN in the place of missing ones.
  std::vector<std::pair<std::string, std::vector<float>>> channels = {};
  std::vector<ScenePose> poses = {};
};

/// Whether the channel comes too fast for frames at `rate` a second.
bool comes_in_stretches(const Channel& channel, double rate);

/// The values that are shown of a channel with `come` frames so far: the latest frame or, for a
/// channel that comes in stretches, the latest stretch; NaN in the place of missing ones.
std::vector<float> shown_values(const Channel& channel, double rate, std::size_t come);

/// The JSON as text; what is no UTF-8 is replaced.
std::string json_text(const Json& json);

/// A frame as text in JSON, which is written directly: it has many numbers many times a second.
std::string frame_text(const ShownMoment& moment, const SystemModel* model, const Reading* reading);

}  // namespace somato::live
