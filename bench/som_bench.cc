// How fast maps are used and trained. Ratios within one run count, not seconds: machines are noisy.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "somato/core/instruction_set.h"
#include "somato/core/random.h"
#include "somato/core/threads.h"
#include "somato/maps/batch_training.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Samples noise(std::size_t count, std::size_t size) {
  Random random(1);
  Matrix<float> rows(count, size);
  for (float& value : rows.values()) value = static_cast<float>(random.uniform());
  return Samples(std::move(rows));
}

void use_set(benchmark::State& state, std::int64_t index) {
  const auto available = available_instruction_sets();
  const auto set = available[std::min(available.size() - 1, static_cast<std::size_t>(index))];
  use_instruction_set(set);
  state.SetLabel(choice_name(set));
}

// Winner search, 64 features on a map of 50 x 50.
void winner_search(benchmark::State& state) {
  use_set(state, state.range(0));
  SomParameters parameters;
  parameters.rows = 50;
  parameters.columns = 50;
  parameters.iterations = 0;
  const Samples samples = noise(1000, 64);
  const Som som = train_som(parameters, samples).value();
  SomWorkspace workspace;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(som.winner(samples[i++ % samples.count()], workspace));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(winner_search)->DenseRange(0, 2);

// Online training on 40 stored samples of 2049 features, as spectra are: plain and by inner
// products.
void online_training(benchmark::State& state) {
  use_set(state, 2);
  SomParameters parameters;
  parameters.iterations = 2000;
  parameters.arithmetic = state.range(0) == 0 ? Arithmetic::kPlain : Arithmetic::kInnerProducts;
  state.SetLabel(choice_name(parameters.arithmetic));
  const Samples samples = noise(40, 2049);
  for (auto _ : state) benchmark::DoNotOptimize(train_som(parameters, samples));
}
BENCHMARK(online_training)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

// One epoch of batch training, 2000 samples of 256 features on a map of 30 x 30, by threads.
void batch_training(benchmark::State& state) {
  use_set(state, 2);
  SomParameters parameters;
  parameters.rows = 30;
  parameters.columns = 30;
  parameters.training = Training::kBatch;
  parameters.epochs = 0;
  const Samples samples = noise(2000, 256);
  Som som = train_som(parameters, samples).value();
  const auto threads = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(batch_epoch(som, samples, 5.0, threads));
}
BENCHMARK(batch_training)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace somato
