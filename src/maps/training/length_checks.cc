#include "maps/training/length_checks.h"

#include <algorithm>
#include <vector>

#include "base/core/threads.h"
#include "maps/reading/winner_search.h"

namespace somato {
namespace {

std::vector<double> distances_by_products(const Som& som, const Samples& samples,
                                          std::span<const std::size_t> numbers) {
  SomWorkspace workspace;
  std::vector<double> distances;
  distances.reserve(numbers.size());
  for (const std::size_t sample : numbers) {
    const std::size_t winner = som.winners(samples, sample, workspace).first;
    distances.push_back(som.distance(samples, sample, winner, workspace));
  }
  return distances;
}

std::vector<double> distances_of_all(const Som& som, const Samples& samples, std::size_t threads) {
  Samples storage;
  const std::vector<std::size_t> winners =
      winners_of_seen(som, seen_samples(som, samples, storage), threads);
  std::vector<double> distances(samples.count());
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = som.distance(samples[i], winners[i], workspace);
    }
  });
  return distances;
}

}  // namespace

void LengthChecks::add(double error) {
  const bool improves = state_.checks == 0 || error < (1.0 - tolerance_) * state_.least_error;
  ++state_.checks;
  if (improves) state_.least_error = error;
  state_.without_improvement = improves ? 0 : state_.without_improvement + 1;
}

std::uint64_t LengthChecks::checks_left() const {
  if (state_.checks >= most_checks_) return 0;
  if (state_.without_improvement >= patience_) return 0;
  const std::uint64_t first = state_.checks == 0 ? 1 : 0;  // has nothing to improve on
  return std::min(first + patience_ - state_.without_improvement, most_checks_ - state_.checks);
}

double mean_distance(const Som& som, const Samples& samples, std::span<const std::size_t> numbers,
                     std::size_t threads) {
  const std::vector<double> distances = som.knows(samples)
                                            ? distances_by_products(som, samples, numbers)
                                            : distances_of_all(som, samples, threads);
  double sum = 0.0;
  for (const double distance : distances) sum += distance;
  return sum / static_cast<double>(distances.size());
}

}  // namespace somato
