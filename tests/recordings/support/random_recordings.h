#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/recording/recording.h"

namespace somato::testing {

/// Text that is UTF-8 but not plain: quotes, line ends, other alphabets, control characters.
inline std::string odd_text(Random& random) {
  const std::vector<std::string> parts{"a",  "\"",   "\\", "\n", "{\"x\":1}", "\xC3\xA9",
                                       " ",  "/",    "_",  ",",  "\x01",      "\xE2\x82\xAC",
                                       "[]", "null", "\t", "%s", "-1",        "\xF0\x9F\x96\x90"};
  std::string text;
  for (std::size_t i = random.below(6); i > 0; --i) text += parts[random.below(parts.size())];
  return text;
}

/// Numbers of all magnitudes, zeros of both signs, the smallest and the largest.
inline float odd_value(Random& random) {
  const std::vector<float> extremes{0.0F,
                                    -0.0F,
                                    std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::lowest(),
                                    std::numeric_limits<float>::denorm_min(),
                                    std::numeric_limits<float>::min()};
  if (random.below(8) == 0) return extremes[random.below(extremes.size())];
  return static_cast<float>(random.normal() * 100.0);
}

/// The double nearest to that many nanoseconds.
inline double second_of(std::int64_t nanoseconds) {
  const std::string digits = std::to_string(10'000'000'000 + std::abs(nanoseconds) % 1'000'000'000);
  return std::stod((nanoseconds < 0 ? "-" : "") +
                   std::to_string(std::abs(nanoseconds) / 1'000'000'000) + "." + digits.substr(2));
}

/// Increasing times from that second on.
inline std::vector<double> random_times(std::size_t count, std::int64_t start, Random& random) {
  std::vector<double> times;
  std::int64_t time =
      start * 1'000'000'000 + static_cast<std::int64_t>(random.below(1'000'000'000));
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(second_of(time));
    if (random.below(4) != 0) time += static_cast<std::int64_t>(random.below(400'000'000));
  }
  return times;
}

/// The properties that all explorations of a recording share.
struct RandomLayout {
  std::vector<std::string> labels;
  std::vector<Channel> channels;  ///< Without frames; a frame of one element gives their number.
  std::vector<std::size_t> elements;
};

inline RandomLayout random_layout(Random& random) {
  RandomLayout layout;
  for (std::size_t i = random.below(4); i > 0; --i) {
    layout.labels.push_back(std::to_string(i) + odd_text(random));
  }
  const std::vector<std::string> names{"joints", "exploration", "exploration_", "touch"};
  const std::size_t channels = 1 + random.below(5);
  for (std::size_t i = 0; i < channels; ++i) {
    Channel channel;
    channel.name = i < names.size() ? names[(i + channels) % names.size()]
                                    : std::to_string(i) + odd_text(random);
    channel.unit = std::vector<std::string>{"deg", "", "counts", odd_text(random)}[random.below(4)];
    std::size_t elements = 1;
    for (std::size_t axes = random.below(4); axes > 0; --axes) {
      channel.shape.push_back(1 + random.below(4));
      elements *= channel.shape.back();
    }
    if (channel.shape.empty()) elements = 1 + random.below(20);
    for (std::size_t e = 0; random.below(2) == 0 && e < elements; ++e) {
      while (channel.element_names.size() < elements) {
        channel.element_names.push_back(std::to_string(channel.element_names.size()) +
                                        odd_text(random));
      }
    }
    layout.channels.push_back(std::move(channel));
    layout.elements.push_back(elements);
  }
  return layout;
}

inline void fill(Channel& channel, std::size_t frames, std::size_t elements, Random& random) {
  channel.frames = Matrix<float>(frames, elements);
  for (float& value : channel.frames.values()) value = odd_value(random);
  if (random.below(3) != 0) return;
  channel.valid = Matrix<std::uint8_t>(frames, elements, 1);
  channel.valid.values()[random.below(frames * elements)] = 0;
  for (std::size_t i = 0; i < frames * elements; ++i) {
    if (random.below(3) == 0) channel.valid.values()[i] = 0;
    if (channel.valid.values()[i] == 0) channel.frames.values()[i] = 0.0F;
  }
}

/// A valid recording of up to six explorations of up to `most_frames` frames a channel.
inline Recording random_recording(Random& random, std::size_t most_frames = 12) {
  const RandomLayout layout = random_layout(random);
  const std::int64_t start = std::vector<std::int64_t>{-3, 0, 0, 1'700'000'000}[random.below(4)];
  Recording recording;
  for (std::size_t i = 1 + random.below(6); i > 0; --i) {
    Exploration exploration;
    for (const std::string& name : layout.labels) {
      exploration.labels.push_back({name, odd_text(random)});
    }
    exploration.source = odd_text(random);
    for (std::size_t c = 0; c < layout.channels.size(); ++c) {
      Channel channel = layout.channels[c];
      const std::size_t frames = 1 + random.below(most_frames);
      fill(channel, frames, layout.elements[c], random);
      const std::size_t clock = random.below(3);
      if (clock == 0) channel.rate = 1.0 + random.uniform() * 5000.0;
      if (clock == 1) channel.times = random_times(frames, start, random);
      exploration.channels.push_back(std::move(channel));
    }
    recording.explorations.push_back(std::move(exploration));
  }
  return recording;
}

}  // namespace somato::testing
