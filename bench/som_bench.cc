// How fast maps are used and trained. Ratios within one run count, not seconds: machines are noisy.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/core/lanes.h"
#include "base/core/threads.h"
#include "base/kernels/instruction_set.h"
#include "maps/grid/neighbourhood.h"
#include "maps/som/map_rows.h"
#include "maps/training/batch_training.h"
#include "somato/core/random.h"
#include "somato/maps/som_learner.h"
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
  state.SetLabel(name_of(set));
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
  for (auto _ : state) {
    benchmark::DoNotOptimize(train_som(parameters, samples.apart())->weights().data());
  }
}
BENCHMARK(online_training)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

// The yardstick: a pass for the winner, and one for the weights of all neurons.
void learn_in_two_passes(Som& som, const SignalView& input, const LearningStep& step,
                         Neighbourhood& neighbourhood, SomWorkspace& workspace) {
  AlignedVector<float> gains(som.weights().padded_rows());
  neighbourhood.around(som.winner(input, workspace), step.radius, gains);
  for (float& gain : gains) gain *= static_cast<float>(step.learning_rate);
  kernels::table<float>().move_towards(kernels::lanes(weights_to_change(som)), input.values.data(),
                                       gains.data());
}

// The same 2000 samples as they stream in: one known at a time, settled after each, and the
// yardstick.
void online_streaming(benchmark::State& state) {
  use_set(state, 2);
  SomParameters parameters;
  parameters.iterations = 2000;
  const Samples samples = noise(40, 2049);
  const Som start = untrained_som(parameters, samples).value();
  const SomParameters& p = start.parameters();
  constexpr const char* kForms[] = {"one by one", "settled each time", "two passes"};
  state.SetLabel(kForms[state.range(0)]);
  for (auto _ : state) {
    Som som = start;
    SomLearner learner(som);
    Neighbourhood neighbourhood(som.grid(), p.neighbourhood);
    SomWorkspace workspace;
    DrawSequence draws(p.draws, samples.count(), p.seed);
    for (std::uint64_t t = 0; t < 2000; ++t) {
      const SignalView input = samples[draws.next()];
      const LearningStep step{p.learning_rate().at(t), p.radius().at(t)};
      if (state.range(0) == 2) {
        learn_in_two_passes(som, input, step, neighbourhood, workspace);
      } else {
        learner.learn(input, step.learning_rate, step.radius);
        if (state.range(0) == 1) learner.settle();
      }
    }
    learner.settle();
    benchmark::DoNotOptimize(som.weights().data());
  }
}
BENCHMARK(online_streaming)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

Samples sparse_noise(std::size_t count, std::size_t size, std::size_t emptiness) {
  Random random(1);
  std::vector<Signal> signals;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (std::uint32_t element = 0; element < size; ++element) {
      if (random.below(emptiness) != 0) continue;
      indices.push_back(element);
      values.push_back(static_cast<float>(random.uniform()));
    }
    signals.push_back(Signal::sparse({size}, std::move(indices), std::move(values)));
  }
  return Samples::from_signals(signals);
}

// The yardstick: the weights that an input of a thousand touches read and written once, where they
// stand side by side.
void touch_rows(const Samples& samples, std::vector<float>& rows, std::size_t neurons) {
  DrawSequence draws(Draws::kWithReplacement, samples.count(), 1);
  for (int t = 0; t < 1000; ++t) {
    for (const std::uint32_t element : samples[draws.next()].indices) {
      float* row = rows.data() + element * neurons;
      for (std::size_t neuron = 0; neuron < neurons; ++neuron) row[neuron] = 0.5F * row[neuron];
    }
  }
  benchmark::DoNotOptimize(rows.data());
}

// A thousand inputs of 270000 elements, 1 % of them not 0, that are not known in advance, on a map
// that begins with zeros: weights for what comes in, weights for all elements, the yardstick.
void sparse_streaming(benchmark::State& state) {
  use_set(state, 2);
  constexpr std::size_t kSize = 270000;
  const Samples samples = sparse_noise(30, kSize, 100);
  SomParameters parameters;
  parameters.iterations = 1000;
  parameters = resolve(parameters, samples.count(), kSize).value();
  const std::size_t neurons = parameters.grid().size();
  constexpr const char* kForms[] = {"elements of inputs", "all elements", "rows touched once"};
  state.SetLabel(kForms[state.range(0)]);
  std::vector<float> rows(state.range(0) == 2 ? kSize * neurons : 0, 1.0F);
  for (auto _ : state) {
    if (state.range(0) == 2) {
      touch_rows(samples, rows, neurons);
      continue;
    }
    Som som = state.range(0) == 0
                  ? Som(parameters, LaneMatrix<float>(neurons, 1), StoredElements(kSize, {0}))
                  : Som(parameters, LaneMatrix<float>(neurons, kSize));
    SomLearner learner(som);
    DrawSequence draws(Draws::kWithReplacement, samples.count(), 1);
    for (std::uint64_t t = 0; t < 1000; ++t) {
      learner.learn(samples[draws.next()], parameters.learning_rate().at(t),
                    parameters.radius().at(t));
    }
    learner.settle();
    benchmark::DoNotOptimize(som.weights().data());
  }
}
BENCHMARK(sparse_streaming)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

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
