// How fast a T-MPSOM of the size of P06's last one is used and trained, a frame at a time.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"

namespace somato {
namespace {

constexpr std::size_t kPosture = 90;
constexpr std::size_t kTouch = 45;

TMpsomParameters large() {
  TMpsomParameters parameters;
  parameters.shape = {46, 23};
  parameters.input_sizes = {kPosture, kTouch};
  return parameters;
}

std::vector<float> noise(Random& random, std::size_t size) {
  std::vector<float> values(size);
  for (float& value : values) value = static_cast<float>(random.uniform());
  return values;
}

// Touch changes with every frame, the posture with every `frames_a_posture`.
struct Frames {
  explicit Frames(std::size_t frames_a_posture) {
    Random random(1);
    for (std::size_t i = 0; i < kCount; ++i) {
      touches.push_back(noise(random, kTouch));
      postures.push_back(i % frames_a_posture == 0 ? noise(random, kPosture) : postures.back());
    }
  }

  std::vector<SignalView> at(std::size_t i) const {
    return {SignalView::dense(postures[i % kCount]), SignalView::dense(touches[i % kCount])};
  }

  static constexpr std::size_t kCount = 64;
  std::vector<std::vector<float>> postures;
  std::vector<std::vector<float>> touches;
};

void t_mpsom_activation(benchmark::State& state) {
  const TMpsom map(large());
  TMpsom::Workspace workspace(map);
  const Frames frames(static_cast<std::size_t>(state.range(0)));
  std::vector<float> activity(map.neurons());
  std::size_t i = 0;
  for (auto _ : state) {
    map.activation(frames.at(i++), workspace, activity);
    benchmark::DoNotOptimize(activity.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(t_mpsom_activation)->ArgName("frames_a_posture")->Arg(1)->Arg(8);

void t_mpsom_learning(benchmark::State& state) {
  TMpsom map(large());
  TMpsom::Workspace workspace(map);
  const Frames frames(1);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(map.learn(frames.at(i++), 0.1, workspace));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(t_mpsom_learning);

}  // namespace
}  // namespace somato
