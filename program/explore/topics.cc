#include "explore/topics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/text/text.h"
#include "bodies/body/kept_frames.h"
#include "explore/placing.h"
#include "recordings/bags/bag_description.h"
#include "terminal/terminal.h"
#ifdef SOMATO_WITH_TOPICS
#include "hardware/topics/topic_explorer.h"
#endif

namespace somato::program {
namespace {

#ifdef SOMATO_WITH_TOPICS

constexpr const char* kChannelAdvice =
    "write NAME:UNIT=/TOPIC:PATH, for example 'touch:N=/xServTopic:sensors[*].taxels[*].z'";

Result<std::vector<topics::TopicSensor>> sensors_of(const Arguments& arguments) {
  if (!arguments.has("channels")) {
    return fail(ErrorKind::kUsage, "the channels of the topics are required", "--channels",
                kChannelAdvice);
  }
  std::vector<topics::TopicSensor> sensors;
  SOMATO_TRY(auto channels, parse_bag_channels(arguments.text("channels")));
  for (BagChannel& channel : channels) {
    topics::TopicSensor sensor{std::move(channel.name),
                               std::move(channel.unit),
                               std::move(channel.topic),
                               std::move(channel.fields),
                               {}};
    const bool twice = std::any_of(sensors.begin(), sensors.end(),
                                   [&](const auto& other) { return other.name == sensor.name; });
    if (twice) {
      return fail(ErrorKind::kUsage, fmt::format("two channels are named '{}'", sensor.name),
                  "--channels", "rename one");
    }
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

Result<KeptFrames> keep_of(const Arguments& arguments) {
  if (!arguments.has("keep")) return KeptFrames::kLatest;
  return choice_named<KeptFrames>("choice of messages", arguments.text("keep"), "--keep");
}

Result<std::vector<ExploredThing>> things_of(const Arguments& arguments) {
  std::vector<ExploredThing> things;
  const std::string names = arguments.has("things") ? arguments.text("things") : "unknown";
  for (const std::string& name : split(names, ',')) {
    if (name.empty()) {
      return fail(ErrorKind::kUsage, "a thing has no name", "--things", "write cup,ball,sponge");
    }
    things.push_back({name, {}, {}});
  }
  return things;
}

// The protocol has no numbers of messages: a gap is all that is seen of one that the robot lost.
void report(const topics::TopicTimes& times, std::size_t dropped) {
  if (!is_quiet() && times.left_out > 0) {
    fmt::print(stderr, "somato: {} messages left out, because they lack elements of a channel\n",
               times.left_out);
  }
  if (is_quiet() || (times.gaps == 0 && dropped == 0)) return;
  fmt::print(stderr,
             "somato: {} messages, usually {:.1f} ms apart; {} gaps, the longest {:.1f} ms; {} "
             "dropped here because they came faster than they were used\n",
             times.messages, 1000.0 * times.usual, times.gaps, 1000.0 * times.longest, dropped);
}

#endif

}  // namespace

std::vector<Flag> topic_flags() {
  return {{"--topics",
           "Address of a robot's topics, such as ws://robot:8765: a Foxglove bridge or a program "
           "with the Foxglove SDK (docs/your-robot.md)"},
          {"--channels",
           "With --topics: the channels, as NAME:UNIT=/TOPIC:PATH+PATH, separated by commas; the "
           "unit is optional. Every message of the first topic is a frame"},
          {"--keep",
           "With --topics: the messages of the other topics that are recorded: latest, with each "
           "frame of the first topic the latest ones, or every, each with its own time. Default: "
           "latest"},
          {"--things",
           "With --topics: names of the things that are explored, separated by commas; a person "
           "places each. Default: one, 'unknown', that is there already"},
          {"--duration", "With --topics: seconds of an exploration. Default: 5"}};
}

Result<void> check_topic_flags(const Arguments& arguments) {
  const bool has_topics = arguments.has("topics");
  for (const char* flag : {"channels", "keep", "things", "duration"}) {
    if (!arguments.has(flag) || has_topics) continue;
    return fail(ErrorKind::kUsage, "has no effect without topics", fmt::format("--{}", flag),
                "add --topics ws://HOST:PORT");
  }
  for (const char* flag :
       {"body", "device", "recording", "objects", "seed", "settings", "images", "threads"}) {
    if (!arguments.has(flag) || !has_topics) continue;
    return fail(ErrorKind::kUsage, "has no effect with topics", fmt::format("--{}", flag),
                "omit it, or --topics");
  }
  return {};
}

Result<BodySession> topic_session(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_topic_flags(arguments));
#ifdef SOMATO_WITH_TOPICS
  topics::TopicExploring exploring;
  exploring.address = arguments.text("topics");
  SOMATO_TRY(exploring.sensors, sensors_of(arguments));
  std::vector<std::string> channels;
  channels.reserve(exploring.sensors.size());
  for (const topics::TopicSensor& sensor : exploring.sensors) channels.push_back(sensor.name);
  SOMATO_TRY(exploring.keep, keep_of(arguments));
  SOMATO_TRY(const auto duration, arguments.number("duration", 1));
  if (duration) exploring.duration = static_cast<double>(*duration);
  if (arguments.has("things")) exploring.place = place_by_person;
  exploring.on_end = report;
  SOMATO_TRY(auto things, things_of(arguments));
  SOMATO_TRY(auto explorer, topics::TopicExplorer::create(std::move(things), std::move(exploring)));
  return BodySession{arguments.text("topics"), {}, {}, std::move(explorer), std::move(channels)};
#else
  return fail(ErrorKind::kUsage, "this program was built without topics of robots", "--topics",
              "install libwebsockets-dev and build it with -DSOMATO_BUILD_TOPICS=ON");
#endif
}

}  // namespace somato::program
