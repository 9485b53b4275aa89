#include "recordings/file/recording_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/text/json_text.h"
#include "base/text/number_of_text.h"
#include "base/text/text.h"

namespace somato {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kJoints = "joints";
constexpr std::string_view kControl = "exploration";
constexpr double kRadiansADegree = std::numbers::pi / 180.0;

tl::unexpected<Error> bad(std::string what) {
  return fail(ErrorKind::kData, std::move(what));
}

std::string name_of(ExplorationMessage::Event event) {
  if (event == ExplorationMessage::Event::kEnd) return "end";
  return event == ExplorationMessage::Event::kBegin ? "begin" : "continue";
}

std::optional<ExplorationMessage::Event> event_of(const std::string& name) {
  using Event = ExplorationMessage::Event;
  for (const Event event : {Event::kBegin, Event::kContinue, Event::kEnd}) {
    if (name_of(event) == name) return event;
  }
  return std::nullopt;
}

// For arbitrary JSON; throws exceptions of the JSON library, or std::invalid_argument.
std::int64_t parse_time(const std::string& digits) {
  const auto time = number_of_text<std::int64_t>(digits);
  if (!time || *time < 0) throw std::invalid_argument("zero is not a number of nanoseconds");
  return *time;
}

ExplorationMessage parse_begin(const Json& json, ExplorationMessage message) {
  for (const Json& label : json.at("labels")) {
    message.labels.push_back(
        {label.at("name").get<std::string>(), label.at("value").get<std::string>()});
  }
  message.source = json.at("source").get<std::string>();
  message.channels = json.at("channels").get<std::vector<std::string>>();
  message.zero = parse_time(json.at("zero").get<std::string>());
  return message;
}

ExplorationMessage parse_message(const Json& json) {
  const auto event = event_of(json.at("event").get<std::string>());
  if (!event) throw std::invalid_argument("the event is neither begin, continue nor end");
  if (!json.at("index").is_number_unsigned()) {
    throw std::invalid_argument("the index is not an integer");
  }
  ExplorationMessage message;
  message.event = *event;
  message.index = json.at("index").get<std::uint64_t>();
  if (message.event == ExplorationMessage::Event::kEnd) return message;
  return parse_begin(json, std::move(message));
}

// The library is slow, and most texts are the same in JSON.
std::string quoted(const std::string& text) {
  const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) {
    return c >= ' ' && c <= '~' && c != '"' && c != '\\';
  });
  return is_plain ? '"' + text + '"' : Json(text).dump();
}

// Runs `parse` on the JSON in `text`; exceptions become errors.
template <typename Parse>
auto read_fields(std::string_view text, std::string_view what, const Parse& parse)
    -> Result<decltype(parse(Json()))> {
  if (text.size() > kLongestExplorationText) {
    return bad(
        fmt::format("{} has {} bytes, more than {}", what, text.size(), kLongestExplorationText));
  }
  auto json = parse_json<Json>(text, std::string(what), {});
  if (!json) return bad(fmt::format("{}: {}", json.error().where, json.error().what));
  try {
    return parse(*json);
  } catch (const Json::exception&) {
    return bad(fmt::format("{} lacks a field, or has one of another type", what));
  } catch (const std::exception& error) {
    return bad(fmt::format("{} is invalid: {}", what, shown(error.what())));
  }
}

// Runs `parse` on the text of that name, if there is one.
template <typename Value, typename Parse>
Result<void> take_metadata(const McapChannel& channel, const std::string& name, Value& value,
                           const Parse& parse) {
  const auto found = channel.metadata.find(name);
  if (found == channel.metadata.end()) return {};
  SOMATO_TRY(auto parsed,
             read_fields(found->second, fmt::format("'{}' of topic {}", name, shown(channel.topic)),
                         parse));
  value = std::move(parsed);
  return {};
}

double parse_rate(const Json& json) {
  const auto rate = json.get<double>();
  if (!(rate > 0.0) || !std::isfinite(rate)) throw std::invalid_argument("the rate is not above 0");
  return rate;
}

std::vector<std::size_t> parse_shape(const Json& json) {
  std::vector<std::size_t> shape;
  for (const Json& length : json) {
    if (!length.is_number_unsigned() || length == 0) {
      throw std::invalid_argument("a length is not above 0");
    }
    shape.push_back(length.get<std::size_t>());
  }
  return shape;
}

// A data channel called like the topic of explorations, or so with underscores behind, gets one
// more: the topic stays free.
bool is_control_name(std::string_view name) {
  return name.starts_with(kControl) &&
         name.find_first_not_of('_', kControl.size()) == std::string_view::npos;
}

std::string name_of_topic(std::string_view topic) {
  std::string_view name = topic.substr(topic.starts_with("/") ? 1 : 0);
  if (is_control_name(name) && name.ends_with('_')) name.remove_suffix(1);
  return std::string(name);
}

bool in_degrees(const ChannelDescription& description) {
  return description.unit == "deg";
}

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) names.push_back(std::to_string(i));
  return names;
}

}  // namespace

McapSchema exploration_schema() {
  constexpr std::string_view kSchema = R"({
  "title": "somato.Exploration",
  "type": "object",
  "properties": {
    "event": {"type": "string", "enum": ["begin", "continue", "end"]},
    "index": {"type": "integer"},
    "labels": {"type": "array", "items": {"type": "object", "properties": {
      "name": {"type": "string"}, "value": {"type": "string"}}}},
    "source": {"type": "string"},
    "channels": {"type": "array", "items": {"type": "string"}},
    "zero": {"type": "string"}
  },
  "required": ["event", "index"]
})";
  return {0, "somato.Exploration", "jsonschema", std::string(kSchema)};
}

McapChannel exploration_channel() {
  return {0, 0, fmt::format("/{}", kControl), "json", {}};
}

bool is_exploration_schema(const McapSchema& schema) {
  return schema.name == exploration_schema().name;
}

std::string exploration_json(const ExplorationMessage& message) {
  std::string json =
      fmt::format(R"({{"event":"{}","index":{})", name_of(message.event), message.index);
  if (message.event == ExplorationMessage::Event::kEnd) return json + "}";
  const auto separator = [&] { return json.ends_with('[') ? "" : ","; };
  json += R"(,"labels":[)";
  for (const Label& label : message.labels) {
    json += fmt::format(R"({}{{"name":{},"value":{}}})", separator(), quoted(label.name),
                        quoted(label.value));
  }
  json += fmt::format(R"(],"source":{},"channels":[)", quoted(message.source));
  for (const std::string& name : message.channels) json += separator() + quoted(name);
  return json + fmt::format(R"(],"zero":"{}"}})", message.zero);
}

Result<ExplorationMessage> parse_exploration_json(std::string_view json) {
  return read_fields(json, "a message of /exploration", parse_message);
}

std::string topic_of(const std::string& name) {
  return "/" + name + (is_control_name(name) ? "_" : "");
}

McapSchema schema_for(const ChannelDescription& description) {
  return description.name == kJoints ? joint_state_schema() : float_array_schema();
}

McapChannel channel_for(const ChannelDescription& description) {
  McapChannel channel{0, 0, topic_of(description.name), "cdr", {}};
  if (!description.unit.empty()) channel.metadata["unit"] = description.unit;
  if (!description.element_names.empty()) {
    channel.metadata["elements"] = Json(description.element_names).dump();
  }
  if (!description.shape.empty()) channel.metadata["shape"] = Json(description.shape).dump();
  if (description.rate > 0.0) {
    channel.metadata["rate"] = Json(description.rate).dump();
  } else if (!description.times_known) {
    channel.metadata["times"] = "unknown";
  }
  return channel;
}

Result<ChannelDescription> parse_description(const McapChannel& channel) {
  ChannelDescription description;
  description.name = name_of_topic(channel.topic);
  const auto text = [&](const char* name, const char* otherwise) {
    const auto found = channel.metadata.find(name);
    return found == channel.metadata.end() ? std::string(otherwise) : found->second;
  };
  description.unit = text("unit", "");
  description.times_known = text("times", "known") != "unknown";
  return take_metadata(channel, "elements", description.element_names,
                       [](const Json& json) { return json.get<std::vector<std::string>>(); })
      .and_then([&] { return take_metadata(channel, "shape", description.shape, parse_shape); })
      .and_then([&] { return take_metadata(channel, "rate", description.rate, parse_rate); })
      .map([&] {
        description.times_known = description.times_known && description.rate == 0.0;
        return std::move(description);
      });
}

std::string frame_message(const ChannelDescription& description, std::uint64_t log_time,
                          std::span<const float> values) {
  if (description.name != kJoints) {
    return float_array_message(
        description.shape.empty() ? std::vector<std::size_t>{values.size()} : description.shape,
        values);
  }
  std::vector<double> positions(values.begin(), values.end());
  if (in_degrees(description)) {
    for (double& position : positions) position *= kRadiansADegree;
  }
  const bool named = description.element_names.size() == values.size();
  return joint_state_message(log_time, named ? description.element_names : numbered(values.size()),
                             positions);
}

std::vector<float> frame_values(const ChannelDescription& description, bool joint_state,
                                std::span<const double> values) {
  const bool converted = joint_state && in_degrees(description);
  std::vector<float> frame;
  frame.reserve(values.size());
  for (const double value : values) {
    frame.push_back(static_cast<float>(converted ? value / kRadiansADegree : value));
  }
  return frame;
}

}  // namespace somato
