// How long a live frame takes through P06's chains, from the sensors to the winner on the map: the
// median and the 99th of 100 frames, in microseconds.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/live_system.h"
#include "somato/graph/system_training.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/study_parameters.h"

namespace somato {
namespace {

constexpr std::size_t kExplorations = 30;
constexpr std::size_t kFrames = 100;

// A hand that wanders, half of its sensors touched.
Channel wandering(const std::string& name, std::size_t elements, double low, double high,
                  Random& random) {
  Matrix<float> frames(kFrames, elements);
  for (std::size_t element = 0; element < elements; ++element) {
    double value = low + (high - low) * random.uniform();
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
      value = std::clamp(value + 0.1 * (high - low) * (random.uniform() - 0.5), low, high);
      frames(frame, element) = static_cast<float>(value);
    }
  }
  return {name, "", {}, std::move(frames), {}, 0.0, {elements}, {}};
}

Channel touched(Random& random) {
  Channel touch = wandering("touch_change", 45, -1.0, 1.0, random);
  for (float& value : touch.frames.values()) value = std::max(value, 0.0F);
  return touch;
}

Recording hand() {
  Random random(1);
  Recording recording;
  for (std::size_t i = 0; i < kExplorations; ++i) {
    recording.explorations.push_back(
        {{},
         {},
         {wandering("height", 1, 100.0, 250.0, random), wandering("wrist", 1, -90.0, 90.0, random),
          wandering("joints", 6, 0.0, 30.0, random), touched(random)}});
  }
  return recording;
}

// Ends the program with the error's message: systems and their channels change.
template <typename T>
T value_of(Result<T> result) {
  if (result) return std::move(*result);
  std::cerr << "live_bench: " << to_string(result.error()) << "\n";
  std::exit(1);
}

System trained(const std::string& name, const Recording& recording) {
  const OwnSystems own = value_of(own_systems());
  const auto file = std::find_if(own.systems.begin(), own.systems.end(),
                                 [&](const NamedFile& one) { return one.name == name; });
  Table table = file->content;
  std::erase_if(table.entries, [](const Table::Entry& entry) {
    return entry.name == "explore" || entry.name == "claim";
  });
  System system = value_of(System::build(value_of(read_study(table)).system, layout_of(recording)));
  Activations activations = value_of(evaluate_fixed(system, recording, {}, 1));
  std::vector<std::size_t> all(kExplorations);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  if (!train_system(system, recording, all, {}, activations)) std::abort();
  return system;
}

double microseconds_of(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void live_frame(benchmark::State& state, const std::string& name) {
  const Recording recording = hand();
  const System system = trained(name, recording);
  LiveSystem live = value_of(LiveSystem::build(system, *system.find("map")));
  std::vector<double> times;
  times.reserve(1U << 20U);
  std::vector<std::span<const float>> values(live.channels().size());
  std::size_t exploration = 0;
  for (auto _ : state) {
    const auto& channels = recording.explorations[exploration++ % kExplorations].channels;
    live.start();
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto channel =
            std::find_if(channels.begin(), channels.end(),
                         [&](const Channel& one) { return one.name == live.channels()[i]; });
        values[i] = channel->frames.row(frame);
      }
      const auto begin = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(live.step(values).has_value());
      benchmark::DoNotOptimize(live.winner());
      const auto end = std::chrono::steady_clock::now();
      times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }
  }
  std::sort(times.begin(), times.end());
  state.counters["p50_us"] = microseconds_of(times, 0.5);
  state.counters["p99_us"] = microseconds_of(times, 0.99);
  state.SetItemsProcessed(static_cast<std::int64_t>(times.size()));
}

BENCHMARK_CAPTURE(live_frame, tensor_chain, std::string("tensor_chain"))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live_frame, t_mpsom, std::string("t_mpsom_multiplied"))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace somato
