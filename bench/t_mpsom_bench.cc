// How fast a T-MPSOM is used and trained, a frame at a time: of the size of P06's last one, and of
// a hundred times as many neurons; and how long a frame takes through P06's chain of them.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "graph/frame_walk.h"
#include "somato/core/random.h"
#include "somato/files/toml_file.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_training.h"
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

// Of the processor, that others on the machine do not count.
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

// In time of the processor. Beside it, as `streaming_us`, what reading and writing the same weights
// once takes by itself: a pass after every iteration, not counted.
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

const char* const kChain = R"(
[module.height_mm]
type = "channel"
channel = "height"
[module.height]
type = "one_hot"
input = "height_mm"
low = 0
high = 1
[module.wrist_deg]
type = "channel"
channel = "wrist"
[module.wrist]
type = "one_hot"
input = "wrist_deg"
low = 0
high = 1
[module.joints_deg]
type = "channel"
channel = "joints"
[module.joints]
type = "one_hot"
input = "joints_deg"
low = 0
high = 1
[module.touch]
type = "channel"
channel = "touch"
[module.hand]
type = "t_mpsom"
inputs = ["wrist", "height"]
shape = [5, 5]
[module.posture]
type = "t_mpsom"
inputs = ["hand", "joints"]
shape = [6, 15]
[module.felt]
type = "t_mpsom"
inputs = ["posture", "touch"]
shape = [46, 23]
[[phase]]
learn = ["hand", "posture", "felt"]
draws = 200
of = "frames"
)";

template <typename T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(*result);
}

// A thousand frames of noise: nothing is ever the same again.
Recording noise_recording() {
  Random random(2);
  Recording recording;
  recording.explorations.emplace_back();
  const std::pair<const char*, std::size_t> channels[] = {
      {"height", 1}, {"wrist", 1}, {"joints", 6}, {"touch", kTouch}};
  for (const auto& [name, elements] : channels) {
    Channel channel;
    channel.name = name;
    channel.shape = {elements};
    channel.frames = Matrix<float>(1000, elements);
    for (float& value : channel.frames.values()) value = static_cast<float>(random.uniform());
    recording.explorations.back().channels.push_back(std::move(channel));
  }
  return recording;
}

double at_share(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// A frame from its channels to what is felt, one after the other as they would come.
void t_mpsom_chain_frame(benchmark::State& state) {
  const Recording recording = noise_recording();
  const Table table = value_of(parse_toml(kChain, "chain"));
  System system = value_of(System::build(value_of(read_system(table)), layout_of(recording)));
  std::vector<std::size_t> all(system.modules().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations known = value_of(evaluate_fixed(system, recording, {}, 1));
  const std::vector<std::size_t> explorations{0};
  value_of(train_system(system, recording, explorations, {}, known).map([] { return true; }));
  std::vector<std::size_t> walked;
  for (const char* name : {"height", "wrist", "joints", "hand", "posture", "felt"}) {
    walked.push_back(value_of(system.find(name)));
  }
  value_of(evaluate(system, recording, explorations, all, 1, known).map([] { return true; }));
  FrameWalk walk(system, walked);
  std::vector<double> spent;
  for (auto _ : state) {
    const bool is_over = spent.size() % 1000 == 0;
    if (is_over && !walk.start([&](std::size_t module) { return known.find(module, 0); })) return;
    const double start = seconds();
    benchmark::DoNotOptimize(walk.step());
    spent.push_back(seconds() - start);
    state.SetIterationTime(spent.back());
  }
  state.counters["p50_us"] = 1e6 * at_share(spent, 0.5);
  state.counters["p99_us"] = 1e6 * at_share(spent, 0.99);
  state.counters["longest_us"] = 1e6 * at_share(spent, 1.0);
}
BENCHMARK(t_mpsom_chain_frame)->Iterations(20000)->UseManualTime();

}  // namespace
}  // namespace somato
