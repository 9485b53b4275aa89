#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/recording/recording.h"

namespace somato::testing {

/// A channel of a made recording: its elements have a value for each kind of object, and noise.
struct MadeSense {
  std::string name;
  std::vector<std::size_t> kinds;  ///< The kind of each object; empty: pure noise.
  double trial_noise = 0.1;        ///< Differs between explorations; values differ by about 1.
  double frame_noise = 0.1;        ///< Differs between frames.
  double scale = 1.0;              ///< A factor of all values.
  std::size_t elements = 3;
  std::size_t frames = 8;
};

inline Channel channel_of(const MadeSense& sense, std::size_t object, std::uint64_t seed,
                          Random& noise) {
  Channel channel;
  channel.name = sense.name;
  channel.frames = Matrix<float>(sense.frames, sense.elements);
  for (std::size_t element = 0; element < sense.elements; ++element) {
    double centre = sense.kinds.empty() ? 0.0 : sense.trial_noise * noise.normal();
    if (!sense.kinds.empty()) {
      Random values(seed * 1000 + element);
      for (std::size_t kind = 0; kind < sense.kinds[object]; ++kind) values.normal();
      centre += values.normal();
    }
    for (std::size_t frame = 0; frame < sense.frames; ++frame) {
      const double value = centre + sense.frame_noise * noise.normal();
      channel.frames(frame, element) = static_cast<float>(sense.scale * value);
    }
  }
  return channel;
}

/// `trials` explorations of each of `objects` objects with these channels and the labels `object`
/// and `trial`.
inline Recording made_senses(std::size_t objects, std::size_t trials,
                             const std::vector<MadeSense>& senses, std::uint64_t seed = 1) {
  Random noise(seed);
  Recording recording;
  for (std::size_t object = 0; object < objects; ++object) {
    for (std::size_t trial = 0; trial < trials; ++trial) {
      Exploration exploration{{{"object", "object " + std::to_string(object + 1)},
                               {"trial", std::to_string(trial + 1)}},
                              {},
                              {}};
      for (std::size_t i = 0; i < senses.size(); ++i) {
        exploration.channels.push_back(channel_of(senses[i], object, seed * 10 + i, noise));
      }
      recording.explorations.push_back(std::move(exploration));
    }
  }
  return recording;
}

/// Frames of one element without noise, one exploration for each list.
inline Recording frames_as_given(const std::string& name,
                                 const std::vector<std::vector<float>>& explorations) {
  Recording recording;
  for (const std::vector<float>& values : explorations) {
    Channel channel;
    channel.name = name;
    channel.frames = Matrix<float>(values.size(), 1, values);
    recording.explorations.push_back({{}, {}, {std::move(channel)}});
  }
  return recording;
}

}  // namespace somato::testing
