// How fast maps are trained on few samples of many elements. Ratios within one run count, not
// seconds: machines are noisy.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Samples dense_noise(std::size_t count, std::size_t size) {
  Random random(1);
  Matrix<float> rows(count, size);
  for (float& value : rows.values()) value = static_cast<float>(random.uniform());
  return Samples(std::move(rows));
}

// With a value in `share` of the elements below `used`.
Samples sparse_noise(std::size_t count, std::size_t size, std::size_t used, double share) {
  Random random(1);
  std::vector<Signal> signals;
  signals.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (std::uint32_t d = 0; d < used; ++d) {
      if (random.uniform() >= share) continue;
      indices.push_back(d);
      values.push_back(static_cast<float>(random.uniform()));
    }
    signals.push_back(Signal::sparse({size}, std::move(indices), std::move(values)));
  }
  return Samples::from_signals(signals);
}

SomParameters parameters_of(std::uint64_t iterations, InitialWeights start, Arithmetic arithmetic) {
  SomParameters p;
  p.iterations = iterations;
  p.initial_weights = start;
  p.arithmetic = arithmetic;
  return p;
}

// With its weights, on the given number of threads.
void whole(benchmark::State& state, const Samples& samples, const SomParameters& parameters) {
  const TrainingOptions options{static_cast<std::size_t>(state.range(0))};
  for (auto _ : state) {
    benchmark::DoNotOptimize(train_som(parameters, samples.apart(), options)->weights().data());
  }
}

// Without weights: what is known of the samples. Products of samples with each other are computed
// anew.
void products(benchmark::State& state, const Samples& samples, const SomParameters& parameters) {
  const TrainingOptions options{static_cast<std::size_t>(state.range(0))};
  SomWorkspace workspace;
  for (auto _ : state) {
    const Samples anew = samples.apart();
    const Som som = train_som(parameters, anew, options).value();
    benchmark::DoNotOptimize(som.winners(anew, 0, workspace));
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// Another seed each time, with the samples' products known.
void seeds(benchmark::State& state, const Samples& samples, SomParameters parameters) {
  const TrainingOptions options{static_cast<std::size_t>(state.range(0))};
  SomWorkspace workspace;
  for (auto _ : state) {
    ++parameters.seed;
    const Som som = train_som(parameters, samples, options).value();
    benchmark::DoNotOptimize(som.winners(samples, 0, workspace));
  }
}

SomParameters batch(InitialWeights start) {
  SomParameters p = parameters_of(0, start, Arithmetic::kInnerProducts);
  p.training = Training::kBatch;
  p.epochs = 33;
  return p;
}

const Samples& mixed() {
  static const Samples samples = sparse_noise(30, 270000, 270000, 0.01);
  return samples;
}

const Samples& chain() {
  static const Samples samples = sparse_noise(30, 270000, 20000, 0.2);
  return samples;
}

SomParameters chained(Arithmetic arithmetic) {
  SomParameters p = parameters_of(1000, InitialWeights::kRange, arithmetic);
  p.normalize_input = true;
  p.radius_start = 15.0;
  return p;
}

constexpr auto kProducts = Arithmetic::kInnerProducts;
constexpr auto kPlain = Arithmetic::kPlain;

#define SOMATO_FEW_SAMPLES(function, name, ...)  \
  BENCHMARK_CAPTURE(function, name, __VA_ARGS__) \
      ->Arg(1)                                   \
      ->Arg(2)                                   \
      ->Unit(benchmark::kMillisecond)            \
      ->UseRealTime()                            \
      ->MeasureProcessCPUTime()

SOMATO_FEW_SAMPLES(products, chain, chain(), chained(kProducts));
SOMATO_FEW_SAMPLES(seeds, chain, chain(), chained(kProducts));
SOMATO_FEW_SAMPLES(products, mixed_range, mixed(),
                   parameters_of(1000, InitialWeights::kRange, kProducts));
SOMATO_FEW_SAMPLES(products, mixed_uniform, mixed(),
                   parameters_of(1000, InitialWeights::kUniform, kProducts));
SOMATO_FEW_SAMPLES(products, mixed_samples, mixed(),
                   parameters_of(1000, InitialWeights::kSamples, kProducts));
SOMATO_FEW_SAMPLES(products, mixed_batch, mixed(), batch(InitialWeights::kRange));
SOMATO_FEW_SAMPLES(products, spectra, dense_noise(40, 2049),
                   parameters_of(2000, InitialWeights::kRange, kProducts));
SOMATO_FEW_SAMPLES(whole, spectra, dense_noise(40, 2049),
                   parameters_of(2000, InitialWeights::kRange, kProducts));
SOMATO_FEW_SAMPLES(whole, spectra_plain, dense_noise(40, 2049),
                   parameters_of(2000, InitialWeights::kRange, kPlain));
SOMATO_FEW_SAMPLES(whole, chain, chain(), chained(kProducts));
SOMATO_FEW_SAMPLES(whole, mixed_range, mixed(),
                   parameters_of(1000, InitialWeights::kRange, kProducts));
SOMATO_FEW_SAMPLES(whole, mixed_uniform, mixed(),
                   parameters_of(1000, InitialWeights::kUniform, kProducts));
SOMATO_FEW_SAMPLES(whole, mixed_samples, mixed(),
                   parameters_of(1000, InitialWeights::kSamples, kProducts));
SOMATO_FEW_SAMPLES(whole, mixed_batch, mixed(), batch(InitialWeights::kRange));
SOMATO_FEW_SAMPLES(whole, mixed_batch_samples, mixed(), batch(InitialWeights::kSamples));

#undef SOMATO_FEW_SAMPLES

}  // namespace
}  // namespace somato
