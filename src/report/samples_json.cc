#include "report/samples_json.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "recording/recording_json.h"
#include "report/short_number.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFrames = 200;
constexpr std::size_t kMostElements = 64;

std::string label_or_nothing(const Exploration& exploration, const std::string& name) {
  return find_label(exploration, name).value_or(std::string());
}

// The name of the explored thing: an object, or else a material.
std::string name_of(const Exploration& exploration, const std::string& studied) {
  for (const std::string& label : {std::string("object"), std::string("material"), studied}) {
    if (std::string name = label_or_nothing(exploration, label); !name.empty()) return name;
  }
  return {};
}

std::string studied_label(const Evidence& evidence) {
  const auto& protocols = evidence.part->protocols;
  return protocols.empty() ? std::string() : protocols.front().label;
}

// The first exploration of each thing among the samples.
std::vector<std::size_t> first_of_each(const Evidence& evidence) {
  std::set<std::string> seen;
  std::vector<std::size_t> first;
  const std::string label = studied_label(evidence);
  for (const std::size_t i : evidence.explorations) {
    if (seen.insert(name_of(evidence.recording->explorations[i], label)).second) {
      first.push_back(i);
    }
  }
  return first;
}

std::vector<ReportThing> labelled_things(const Evidence& evidence) {
  std::vector<ReportThing> things;
  const std::string label = studied_label(evidence);
  for (const std::size_t i : first_of_each(evidence)) {
    const Exploration& exploration = evidence.recording->explorations[i];
    ReportThing thing;
    thing.name = name_of(exploration, label);
    thing.shape = label_or_nothing(exploration, "shape");
    thing.material = label_or_nothing(exploration, "material");
    thing.hardness = label_or_nothing(exploration, "hardness");
    things.push_back(std::move(thing));
  }
  return things;
}

// Without a recording the classes are all there is, where they are things.
std::vector<ReportThing> studied_things(const Evidence& evidence) {
  std::vector<ReportThing> things;
  std::set<std::string> seen;
  for (const ProtocolResults& protocol : evidence.part->protocols) {
    if (protocol.label != "object" && protocol.label != "material") continue;
    for (const Run& run : protocol.runs) {
      for (const std::string& name : run.labels) {
        if (seen.insert(name).second) things.push_back({name, {}, {}, 0.0, {}, {}, {}, {}});
      }
    }
  }
  return things;
}

bool agree(const std::string& labelled, const std::string& known) {
  return labelled.empty() || known.empty() || labelled == known;
}

// An object of another source may have the same name.
void complete(ReportThing& thing, const std::vector<ReportThing>& known) {
  for (const ReportThing& one : known) {
    if (one.name != thing.name || !agree(thing.shape, one.shape) ||
        !agree(thing.material, one.material) || !agree(thing.hardness, one.hardness)) {
      continue;
    }
    thing = one;
    return;
  }
}

template <typename Array>
Json triple_json(const std::optional<Array>& values) {
  return values ? Json(*values) : Json(nullptr);
}

Json thing_json(const ReportThing& thing) {
  return {{"name", thing.name},
          {"shape", thing.shape.empty() ? Json(nullptr) : Json(thing.shape)},
          {"size", triple_json(thing.size)},
          {"top_diameter", thing.top_diameter},
          {"material", thing.material},
          {"hardness", thing.hardness},
          {"colour", triple_json(thing.colour)},
          {"mass", thing.mass ? Json(*thing.mass) : Json(nullptr)}};
}

double time_of(const Channel& channel, std::size_t frame) {
  if (!channel.times.empty()) return channel.times[frame];
  const double rate = channel.frame_rate();
  return static_cast<double>(frame) / (rate > 0.0 ? rate : 1.0);
}

bool has_times(const Channel& channel) {
  return !channel.times.empty() || channel.rate > 0.0;
}

std::size_t frame_of_most(const Channel& channel) {
  std::size_t most = 0;
  double greatest = -INFINITY;
  for (std::size_t frame = 0; frame < channel.frames.rows(); ++frame) {
    double sum = 0.0;
    for (const float value : channel.frames.row(frame)) sum += double{value};
    if (sum <= greatest) continue;
    greatest = sum;
    most = frame;
  }
  return most;
}

std::size_t nearest_frame(const Channel& channel, double time) {
  std::size_t nearest = 0;
  for (std::size_t frame = 1; frame < channel.frames.rows(); ++frame) {
    const double here = std::abs(time_of(channel, frame) - time);
    if (here < std::abs(time_of(channel, nearest) - time)) nearest = frame;
  }
  return nearest;
}

// The frame of a channel at the moment of most touch.
std::size_t frame_of(const Channel& channel, const Channel* touch) {
  const std::size_t last = channel.frames.rows() - 1;
  if (!touch) return last;
  const std::size_t most = frame_of_most(*touch);
  if (touch->frames.rows() == channel.frames.rows()) return most;
  if (!has_times(*touch) || !has_times(channel)) return last;
  return nearest_frame(channel, time_of(*touch, most));
}

// From the first to the last, the moment among them.
std::vector<std::size_t> evenly_chosen(std::size_t frames, std::size_t moment) {
  const std::size_t count = std::min(frames, kMostFrames);
  std::vector<std::size_t> chosen(count);
  for (std::size_t i = 0; i < count; ++i) {
    chosen[i] = count == 1 ? 0 : i * (frames - 1) / (count - 1);
  }
  if (count < 3 || moment == 0 || moment + 1 == frames) return chosen;
  const auto after = std::lower_bound(chosen.begin(), chosen.end(), moment);
  *std::min(after, chosen.end() - 2) = moment;
  return chosen;
}

Json moment_channel(const Channel& channel, const Channel* touch) {
  const std::size_t moment = frame_of(channel, touch);
  Json times = Json::array();
  Json series = Json::array();
  for (const std::size_t frame : evenly_chosen(channel.frames.rows(), moment)) {
    times.push_back(short_number(time_of(channel, frame)));
    if (channel.frames.columns() > kMostElements) continue;
    series.push_back(short_numbers(channel.frames.row(frame)));
  }
  return {{"channel", channel_json(channel)},
          {"rate", short_number(channel.frame_rate())},
          {"frame", moment},
          {"time", short_number(time_of(channel, moment))},
          {"values", short_numbers(channel.frames.row(moment))},
          {"times", std::move(times)},
          {"series", std::move(series)}};
}

const Channel* touch_of(const Exploration& exploration) {
  const auto found = find_channel(exploration, "touch");
  return found ? *found : nullptr;
}

}  // namespace

Json samples_json(const Evidence& evidence) {
  if (!evidence.recording) return nullptr;
  Json json = Json::array();
  for (const std::size_t i : evidence.explorations) {
    json.push_back(labels_json(evidence.recording->explorations[i].labels));
  }
  return json;
}

Json things_json(const Evidence& evidence, const std::vector<ReportThing>& known) {
  Json json = Json::array();
  for (ReportThing& thing :
       evidence.recording ? labelled_things(evidence) : studied_things(evidence)) {
    complete(thing, known);
    json.push_back(thing_json(thing));
  }
  return json;
}

Json moments_json(const Evidence& evidence) {
  Json json = Json::array();
  if (!evidence.recording) return json;
  for (const std::size_t i : first_of_each(evidence)) {
    const Exploration& exploration = evidence.recording->explorations[i];
    Json channels = Json::array();
    for (const Channel& channel : exploration.channels) {
      channels.push_back(moment_channel(channel, touch_of(exploration)));
    }
    json.push_back(
        {{"labels", labels_json(exploration.labels)}, {"channels", std::move(channels)}});
  }
  return json;
}

}  // namespace somato::detail
