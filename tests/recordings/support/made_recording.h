#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/recording/recording.h"

namespace somato::testing {

/// An exploration of `object` with a channel `joints` of one frame.
inline Exploration exploration_of(const std::string& object, std::vector<float> joints) {
  const std::size_t size = joints.size();
  return {{{"object", object}},
          {},
          {{"joints", "deg", {}, Matrix<float>(1, size, std::move(joints)), {}}}};
}

/// `trials` explorations of each of `objects` objects, one object after the other: three joints
/// within `noise` of 100, 200 and so on times the object's number.
inline Recording objects_apart(std::size_t objects, std::size_t trials, double noise,
                               std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t object = 0; object < objects; ++object) {
    for (std::size_t trial = 0; trial < trials; ++trial) {
      std::vector<float> joints;
      for (std::size_t joint = 1; joint <= 3; ++joint) {
        const double centre = 100.0 * static_cast<double>(joint * object);
        joints.push_back(static_cast<float>(centre + noise * (2.0 * random.uniform() - 1.0)));
      }
      recording.explorations.push_back(
          exploration_of("object " + std::to_string(object + 1), std::move(joints)));
    }
  }
  return recording;
}

}  // namespace somato::testing
