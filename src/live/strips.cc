#include "live/strips.h"

#include <algorithm>
#include <functional>

#include "live/json_writer.h"
#include "live/view_json.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostMoments = 600;    // a strip has hardly more pixels
constexpr std::size_t kMostValues = 200000;  // in all

// How an exploration goes on.
struct Course {
  std::size_t moments = 0;
  std::function<double(std::size_t moment)> time;
  std::function<double(std::size_t channel)> rate;
  std::function<std::size_t(std::size_t channel, std::size_t moment)> frames;
};

std::vector<std::size_t> shown_channels(const Exploration& exploration, const Course& course) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    if (!comes_in_stretches(exploration.channels[i], course.rate(i))) shown.push_back(i);
  }
  return shown;
}

std::size_t most_moments(const Exploration& exploration, const std::vector<std::size_t>& channels) {
  std::size_t values = 1;
  for (const std::size_t i : channels) values += exploration.channels[i].frames.columns();
  return std::clamp<std::size_t>(kMostValues / values, 1, kMostMoments);
}

// The last is among them: what has been felt ends there.
std::vector<std::size_t> evenly_chosen(std::size_t all, std::size_t most) {
  const std::size_t count = std::min(all, most);
  std::vector<std::size_t> chosen;
  chosen.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) chosen.push_back(all * i / count - 1);
  return chosen;
}

Strips chosen_of(const Exploration& exploration, std::size_t number, const Course& course) {
  const std::vector<std::size_t> channels = shown_channels(exploration, course);
  Strips strips{number};
  strips.frame = evenly_chosen(course.moments, most_moments(exploration, channels));
  for (const std::size_t moment : strips.frame) strips.time.push_back(course.time(moment));
  for (const std::size_t i : channels) {
    const Channel& channel = exploration.channels[i];
    Strips::Channel& told = strips.channels.emplace_back(Strips::Channel{channel.name, {}});
    for (const std::size_t moment : strips.frame) {
      const auto values = shown_values(channel, course.rate(i), course.frames(i, moment));
      told.values.emplace_back(values.begin(), values.end());
    }
  }
  return strips;
}

}  // namespace

Strips strips_of(const Exploration& exploration, std::size_t number, const Timeline& timeline) {
  Strips strips = chosen_of(
      exploration, number,
      {timeline.moments(), [&](std::size_t moment) { return timeline.time(moment); },
       [&](std::size_t channel) { return timeline.rate(channel); },
       [&](std::size_t channel, std::size_t moment) { return timeline.frames(channel, moment); }});
  strips.frames = timeline.moments();
  return strips;
}

Strips strips_of(const GrowingExploration& growing, std::size_t number, double begun) {
  const auto& channels = growing.so_far().channels;
  return chosen_of(
      growing.so_far(), number,
      {growing.moments(), [&](std::size_t moment) { return growing.moment(moment).time - begun; },
       [&](std::size_t channel) { return channels[channel].rate; },
       [&](std::size_t channel, std::size_t moment) {
         return growing.moment(moment).frames[channel];
       }});
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
