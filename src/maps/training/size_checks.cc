#include "maps/training/size_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/core/threads.h"
#include "maps/analysis/paired_errors.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr std::size_t kHeldOut = 5;               // the first of so many samples
constexpr std::size_t kMostSamplesOfNeuron = 16;  // of the smallest map
constexpr std::uint64_t kEpochs = 20;
constexpr double kRadiusEnd = 0.3;  // neighbours then learn a 250th of the winner

// The numbers of the samples that are learned, and of those that are held out.
struct Division {
  std::vector<std::size_t> learned;
  std::vector<std::size_t> held_out;
};

Division divided(std::size_t count) {
  Division division;
  for (std::size_t i = 0; i < count; ++i) {
    (i % kHeldOut == 0 ? division.held_out : division.learned).push_back(i);
  }
  return division;
}

SomParameters parameters_for(std::size_t side, Similarity similarity) {
  SomParameters parameters;
  parameters.rows = side;
  parameters.columns = side;
  parameters.similarity = similarity;
  parameters.initial_weights = InitialWeights::kSamples;
  parameters.training = Training::kBatch;
  parameters.epochs = kEpochs;
  parameters.radius_schedule = ScheduleShape::kExponential;
  parameters.radius_end = kRadiusEnd;
  return parameters;
}

double distance_of(const Som& som, const Samples& samples, std::size_t sample,
                   SomWorkspace& workspace) {
  if (som.knows(samples)) {
    return som.distance(samples, sample, som.winners(samples, sample, workspace).first, workspace);
  }
  return som.distance(samples[sample], som.winner(samples[sample], workspace), workspace);
}

std::vector<double> distances_of(const Som& som, const Samples& samples,
                                 const std::vector<std::size_t>& numbers, std::size_t threads) {
  std::vector<double> distances(numbers.size());
  for_each_range(numbers.size(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = distance_of(som, samples, numbers[i], workspace);
    }
  });
  return distances;
}

std::size_t side_for(double neurons) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(neurons)));
}

}  // namespace

Result<MeasuredSize> measured_size(const Samples& samples, Similarity similarity,
                                   std::size_t threads,
                                   const std::function<Result<void>()>& proceed) {
  if (samples.count() < kHeldOut) return MeasuredSize{};
  const Division division = divided(samples.count());
  const auto learned = static_cast<double>(division.learned.size());
  MeasuredSize measured;
  std::vector<double> least;
  for (std::size_t samples_of_neuron = kMostSamplesOfNeuron; samples_of_neuron > 0;
       samples_of_neuron /= 2) {
    SOMATO_TRY_VOID(proceed());
    const double share = 1.0 / static_cast<double>(samples_of_neuron);
    const std::size_t side = side_for(share * learned);
    if (!measured.checks.empty() && measured.checks.back().neurons == side * side) continue;
    SOMATO_TRY(const Som som, train_som(parameters_for(side, similarity), samples,
                                        {.threads = threads, .training = division.learned}));
    std::vector<double> distances = distances_of(som, samples, division.held_out, threads);
    const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
    measured.checks.push_back({side * side, sum / static_cast<double>(distances.size())});
    if (!least.empty() && !is_clearly_better(distances, least)) return measured;
    measured.share = share;
    least = std::move(distances);
  }
  return measured;
}

}  // namespace somato
