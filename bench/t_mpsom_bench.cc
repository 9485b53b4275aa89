// How fast a T-MPSOM is used and trained, a frame at a time: of the size of P06's last one, and of
// a hundred times as many neurons.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <ctime>
#include <vector>

#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"

namespace somato {
namespace {

constexpr std::size_t kPosture = 90;
constexpr std::size_t kTouch = 45;

// 46 x 23 neurons, `scale` times as many along each axis.
TMpsomParameters map_of(std::size_t scale) {
  TMpsomParameters parameters;
  parameters.shape = {46 * scale, 23 * scale};
  parameters.input_sizes = {kPosture, kTouch};
  return parameters;
}

// One element in `one_in` is not zero.
std::vector<float> noise(Random& random, std::size_t size, std::size_t one_in) {
  std::vector<float> values(size);
  for (float& value : values) {
    if (random.below(one_in) == 0) value = static_cast<float>(random.uniform());
  }
  return values;
}

// Touch changes with every frame, the posture with every `frames_a_posture`.
struct Frames {
  explicit Frames(std::size_t frames_a_posture, std::size_t one_in = 1) {
    Random random(1);
    for (std::size_t i = 0; i < kCount; ++i) {
      touches.push_back(noise(random, kTouch, one_in));
      postures.push_back(i % frames_a_posture == 0 ? noise(random, kPosture, one_in)
                                                   : postures.back());
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
  const TMpsom map(map_of(1));
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

// Returns the processor's time, which does not count other processes of the machine.
double seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Seconds to read and write as many values once, one in a while.
class Streaming {
 public:
  explicit Streaming(std::size_t values) : values_(values, 0.5F) {}

  void measure() {
    const double start = seconds();
    for (float& value : values_) value = 0.99F * value + 0.001F;
    benchmark::DoNotOptimize(values_.data());
    benchmark::ClobberMemory();
    spent_ += seconds() - start;
    ++count_;
  }

  double seconds_a_pass() const { return spent_ / static_cast<double>(count_); }

 private:
  AlignedVector<float> values_;
  double spent_ = 0.0;
  std::size_t count_ = 0;
};

// Beside it, as `streaming_us`, what reading and writing the same weights once takes by itself: a
// pass after every iteration, not counted.
void t_mpsom_learning(benchmark::State& state) {
  TMpsom map(map_of(static_cast<std::size_t>(state.range(0))));
  TMpsom::Workspace workspace(map);
  const Frames frames(1, static_cast<std::size_t>(state.range(1)));
  Streaming streaming(map.neurons() * (kPosture + kTouch));
  double spent = 0.0;
  std::size_t i = 0;
  for (auto _ : state) {
    const auto inputs = frames.at(i++);
    const double start = seconds();
    benchmark::DoNotOptimize(map.learn(inputs, 0.1, workspace));
    const double end = seconds();
    state.SetIterationTime(end - start);
    spent += end - start;
    streaming.measure();
  }
  const auto bytes = static_cast<double>(map.neurons() * (kPosture + kTouch) * 2 * sizeof(float));
  state.SetItemsProcessed(state.iterations());
  state.counters["bytes_per_second"] = bytes * static_cast<double>(i) / spent;
  state.counters["streaming_us"] = 1e6 * streaming.seconds_a_pass();
  state.counters["streaming_passes"] = spent / static_cast<double>(i) / streaming.seconds_a_pass();
}
BENCHMARK(t_mpsom_learning)
    ->ArgNames({"scale", "one_in"})
    ->ArgsProduct({{1, 10}, {1, 10}})
    ->UseManualTime();

}  // namespace
}  // namespace somato
