#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bodies/body/frame_log.h"
#include "somato/bodies/explorer.h"
#include "somato/core/random.h"

namespace somato::testing {

/// Explores without physics, with the channels of hand_recording() but for the sound: steps of a
/// tenth of a second, of which it records every other one. Its sensations depend on the thing and
/// the trial only.
class FakeExplorer : public SimulatedExplorer {
 public:
  explicit FakeExplorer(std::size_t steps = 10)
      : SimulatedExplorer({thing("ball"), thing("cube")}, ""), steps_(steps) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    if (options.placement && options.placement->x > 40.0) {
      return fail(ErrorKind::kData, "the object is out of reach");
    }
    Scene scene;
    scene.bodies = {"finger"};
    if (auto begun = options.observer.on_begin(description(), scene); !begun) {
      return fail(std::move(begun.error()));
    }
    FrameLog log(description(), options.limits.memory);
    Random random(1000 * thing + trial);
    BodyState state;
    for (std::size_t step = 0; step < steps_; ++step) {
      state.time += 0.1;
      feel(random, state);
      ScenePose pose;
      pose.position[0] = static_cast<double>(step);
      const Readings readings = step % 2 == 0 ? Readings::kLeftOut : Readings::kRecorded;
      if (auto seen = options.observer.on_step({state, {pose}, readings}); !seen) {
        return fail(std::move(seen.error()));
      }
      if (readings == Readings::kLeftOut) continue;
      if (auto kept = log.append(state); !kept) return fail(std::move(kept.error()));
    }
    return Exploration{{{"object", things()[thing].name}}, "", std::move(log).channels()};
  }

 private:
  static ExploredThing thing(const std::string& name) {
    Object object;
    object.name = name;
    object.size = {50.0, 50.0, 50.0};
    object.material.name = "wood";
    return {name, object, object.material};
  }

  static BodyDescription description() {
    BodyDescription body;
    body.name = "fake";
    for (const auto& [name, shape] : channels()) {
      ChannelDescription sensor;
      sensor.name = name;
      sensor.shape = shape;
      body.sensors.push_back(std::move(sensor));
    }
    return body;
  }

  static std::vector<std::pair<std::string, std::vector<std::size_t>>> channels() {
    return {{"height", {1}}, {"wrist", {1}}, {"joints", {3}}, {"touch", {2, 2}}};
  }

  static void feel(Random& random, BodyState& state) {
    state.readings.clear();
    for (const std::size_t elements : {1U, 1U, 3U, 4U}) {
      Matrix<float> frame(1, elements);
      for (float& value : frame.values()) value = static_cast<float>(random.uniform());
      state.readings.push_back(std::move(frame));
    }
  }

  std::size_t steps_;
};

}  // namespace somato::testing
