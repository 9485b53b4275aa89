#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/frame_log.h"
#include "somato/bodies/watched_body.h"
#include "somato/core/random.h"

namespace somato::testing {

/// A body without physics, with the channels of hand_recording() but for the sound: ten steps of a
/// tenth of a second, of which it records every other one. What it feels depends on the thing and
/// the trial alone.
class FakeWatchedBody : public WatchedBody {
 public:
  explicit FakeWatchedBody(std::size_t steps = 10) : steps_(steps) {
    Material material;
    material.name = "wood";
    things_ = {{"ball", {}, material}, {"cube", {}, material}};
  }

  const std::string& name() const override { return name_; }
  const std::vector<ShownThing>& things() const override { return things_; }
  bool takes_placement() const override { return true; }

  Result<Exploration> explore(const WatchedExploration& what,
                              ExplorationWatcher& watcher) const override {
    if (what.placement.x > 100.0) return fail(ErrorKind::kData, "the object is out of reach");
    Scene scene;
    scene.bodies = {"finger"};
    watcher.begins(description(), scene);
    FrameLog log(description(), [&](const BodyState& state) { return watcher.felt(state); });
    Random random(1000 * what.thing + what.trial);
    BodyState state;
    for (std::size_t step = 0; step < steps_; ++step) {
      state.time += 0.1;
      feel(random, state);
      ScenePose pose;
      pose.position[0] = static_cast<double>(step);
      if (auto seen = watcher.moved(state, {pose}); !seen) return fail(std::move(seen.error()));
      if (step % 2 == 0) continue;
      if (auto kept = log.append(state); !kept) return fail(std::move(kept.error()));
    }
    return Exploration{{{"object", things_[what.thing].name}}, "", std::move(log).channels()};
  }

 private:
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

  std::string name_ = "fake";
  std::size_t steps_;
  std::vector<ShownThing> things_;
};

}  // namespace somato::testing
