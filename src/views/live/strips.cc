#include "views/live/strips.h"

#include <algorithm>

#include "views/session/json_writer.h"
#include "views/session/view_json.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostMoments = 600;    // a strip has hardly more pixels
constexpr std::size_t kMostValues = 200000;  // in all

std::vector<std::size_t> shown_channels(const PlayedExploration& played) {
  std::vector<std::size_t> shown;
  const auto& channels = played.exploration->channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!comes_in_stretches(channels[i], played.timeline->rate(i))) shown.push_back(i);
  }
  return shown;
}

std::size_t most_moments(const Exploration& exploration, const std::vector<std::size_t>& channels) {
  std::size_t values = 1;
  for (const std::size_t i : channels) values += exploration.channels[i].frames.columns();
  return std::clamp<std::size_t>(kMostValues / values, 1, kMostMoments);
}

// The last is among them: what has been felt ends there.
std::vector<std::size_t> evenly_chosen(std::size_t first, std::size_t end, std::size_t most) {
  const std::size_t all = end - first;
  const std::size_t count = std::min(all, most);
  std::vector<std::size_t> chosen;
  chosen.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) chosen.push_back(first + all * i / count - 1);
  return chosen;
}

}  // namespace

Strips strips_of(const PlayedExploration& played) {
  const Timeline& timeline = *played.timeline;
  const std::vector<std::size_t> channels = shown_channels(played);
  Strips strips{played.index};
  if (played.has_ended) strips.frames = timeline.moments();
  strips.frame = evenly_chosen(timeline.first(), timeline.moments(),
                               most_moments(*played.exploration, channels));
  for (const std::size_t moment : strips.frame) strips.time.push_back(timeline.time(moment));
  for (const std::size_t i : channels) {
    const Channel& channel = played.exploration->channels[i];
    Strips::Channel& strip = strips.channels.emplace_back(Strips::Channel{channel.name, {}});
    for (const std::size_t moment : strips.frame) {
      const std::size_t come = timeline.frames(i, moment);
      const std::size_t kept = come == 0 ? 0 : come - timeline.dropped(i);
      strip.values.push_back(shown_values(channel, timeline.rate(i), kept));
    }
  }
  return strips;
}

std::string strips_text(const Strips& strips) {
  JsonWriter text;
  text.open('{');
  text.key("exploration").add("{}", strips.exploration);
  text.key("frames").add("{}", strips.frames ? std::to_string(*strips.frames) : "null");
  text.key("frame").add("[{}]", fmt::join(strips.frame, ","));
  text.key("time").open('[');
  for (const double time : strips.time) text.separate().finite("{:.6g}", time);
  text.close(']');
  text.key("channels").open('{');
  for (const Strips::Channel& channel : strips.channels) {
    text.key(channel.name).open('[');
    for (const auto& values : channel.values) text.separate().exact_numbers(values);
    text.close(']');
  }
  text.close('}').close('}');
  return std::move(text).take();
}

}  // namespace somato::live
