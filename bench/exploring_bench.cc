// How fast the simulated bodies explore: against real time on one core, what share of it is not
// physics, and explorations a second on one and two threads.

#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "bodies/hands/simulated_hand_impl.h"
#include "somato/bodies/explore_by.h"
#include "somato/bodies/exploring.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

double milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// The thing with that index in a table; the index is written as the benchmark's label.
const Object& thing_of(benchmark::State& state, ExploringBody body) {
  static const ObjectTable two = default_things(ExploringBody::kLucs2).value();
  static const ObjectTable three = default_things(ExploringBody::kLucs3).value();
  const auto& objects = (body == ExploringBody::kLucs2 ? two : three).objects;
  const Object& object = objects[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(object.name);
  return object;
}

// Explores one thing again and again, the engine counting its own time.
void explore_thing(benchmark::State& state, ExploringBody body) {
  const Object& object = thing_of(state, body);
  const Hand which = body == ExploringBody::kLucs2 ? Hand::kLucs2 : Hand::kLucs3;
  SimulationParameters parameters;
  parameters.free = state.range(1) != 0;
  const HandScene scene = HandScene::build(which, object, parameters).value();
  mjcb_time = milliseconds;
  std::vector<double> factors;
  std::vector<double> shares;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    Random random(++seed);
    const double begin = milliseconds();
    const auto hand =
        SimulatedHand::create(scene, draw_placement(parameters, random), seed).value();
    const auto exploration = body == ExploringBody::kLucs2 ? explore_by_grasping(*hand, {}, {})
                                                           : explore_by_closing(*hand, {});
    const double took = milliseconds() - begin;
    benchmark::DoNotOptimize(exploration);
    if (!exploration) state.SkipWithError(exploration.error().what.c_str());
    factors.push_back(1000 * hand->state().time / took);
    shares.push_back(1 - hand->impl().data->timer[mjTIMER_STEP].duration / took);
  }
  mjcb_time = nullptr;
  state.counters["times_real_time"] = median(factors);
  state.counters["share_outside_physics"] = median(shares);
}

void hand_two(benchmark::State& state) {
  explore_thing(state, ExploringBody::kLucs2);
}
void hand_three(benchmark::State& state) {
  explore_thing(state, ExploringBody::kLucs3);
}

// All things of the body's own table, each once, on so many threads.
void explorations(benchmark::State& state, ExploringBody body) {
  const ObjectTable things = default_things(body).value();
  const auto explorer = simulated_explorer(body, things, {}, 1).value();
  const auto threads = static_cast<std::size_t>(state.range(0));
  std::size_t explored = 0;
  for (auto _ : state) {
    const auto outcome =
        explore_all(*explorer, {2}, threads, {}, [](Exploration&&) { return Result<void>(); });
    explored += outcome.value().recorded;
  }
  state.counters["explorations"] =
      benchmark::Counter(static_cast<double>(explored), benchmark::Counter::kIsRate);
}

// Name, thing, free.
BENCHMARK(hand_two)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}})
    ->ArgNames({"thing", "free"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(hand_three)
    ->ArgsProduct({{0, 4, 5, 9}, {0, 1}})
    ->ArgNames({"thing", "free"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(explorations, lucs2, ExploringBody::kLucs2)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(explorations, lucs3, ExploringBody::kLucs3)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(explorations, texture, ExploringBody::kTexture)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace somato
