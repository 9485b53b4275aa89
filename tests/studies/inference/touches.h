#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/files/toml_file.h"
#include "somato/core/random.h"
#include "somato/recording/recording.h"

namespace somato::test {

/// The settings of a synthetic body.
struct SyntheticBody {
  double level = 2.0;
  double gain = 1.0;
  double noise = 0.1;
  double tone = 0.0;  ///< Amplitude of a sine in the sound.
};

/// An exploration of `object` with three touch elements, which rise with the object's number, and
/// sound of 64 frames at 100 Hz.
inline Exploration synthetic_touch(const SyntheticBody& body, int object, int trial,
                                   Random& random) {
  Exploration exploration;
  exploration.labels = {{"object", std::string(1, static_cast<char>('a' + object))},
                        {"trial", std::to_string(trial)}};
  exploration.source = "synthetic";
  Channel touch;
  touch.name = "touch";
  touch.unit = "N";
  touch.frames = Matrix<float>(8, 3);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t e = 0; e < 3; ++e) {
      const double force = 0.2 * static_cast<double>(i * (e + 1)) + object;
      touch.frames(i, e) =
          static_cast<float>(body.level + body.gain * force + body.noise * random.normal());
    }
  }
  Channel sound;
  sound.name = "sound";
  sound.rate = 100.0;
  sound.frames = Matrix<float>(64, 1);
  for (std::size_t i = 0; i < 64; ++i) {
    sound.frames(i, 0) =
        static_cast<float>(body.tone * std::sin(0.8 * static_cast<double>(i)) + random.normal());
  }
  exploration.channels = {touch, sound};
  return exploration;
}

inline Recording synthetic_recording(const SyntheticBody& body, int objects, int trials,
                                     std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (int object = 0; object < objects; ++object) {
    for (int trial = 0; trial < trials; ++trial)
      recording.explorations.push_back(synthetic_touch(body, object, trial, random));
  }
  return recording;
}

}  // namespace somato::test
