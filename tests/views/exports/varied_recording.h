#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "somato/core/random.h"
#include "somato/recording/recording.h"

namespace somato {

/// Two explorations, whose first frames are at 0 s: joints in degrees with names at 50 Hz; an array
/// of taxels with irregular times, missing values and neighbouring float32 numbers; a channel with
/// names that are no names of columns.
inline Recording varied_recording() {
  Recording recording;
  Random random(7);
  for (const std::size_t frames : {3U, 4U}) {
    Channel joints{"joints", "deg", {"thumb", "index"}, Matrix<float>(frames, 2), {}, 50.0};
    Channel skin{"skin/left", "counts", {}, Matrix<float>(frames, 6), {}, 0.0, {2, 3}};
    Channel other{"other", "", {"a", "b*"}, Matrix<float>(frames, 2), {}, 0.0};
    skin.valid = Matrix<std::uint8_t>(frames, 6, 1);
    skin.valid(1, 5) = 0;
    for (std::size_t frame = 0; frame < frames; ++frame) {
      for (std::size_t i = 0; i < 2; ++i) {
        joints.frames(frame, i) = static_cast<float>(90.0 * random.uniform());
        other.frames(frame, i) = static_cast<float>(1e-30 * random.uniform());
      }
      for (std::size_t i = 0; i < 6; ++i) {
        skin.frames(frame, i) = frame % 2 == 0 ? 0.1F : std::nextafter(0.1F, 1.0F);
      }
      const double time = static_cast<double>(frame * frame) / 1000.0;
      skin.times.push_back(time);
      other.times.push_back(time);
    }
    skin.frames(1, 5) = 0.0F;
    recording.explorations.push_back(
        {{{"object", "cup, \"old\""}, {"trial number", frames == 3 ? "1" : "T\u00fcr"}},
         "",
         {joints, skin, other}});
  }
  return recording;
}

}  // namespace somato
