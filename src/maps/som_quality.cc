#include "somato/maps/som_quality.h"

#include <cmath>

#include "maps/winner_search.h"
#include "somato/core/check.h"
#include "somato/core/threads.h"

namespace somato {
namespace {

double weight_distance(const Som& som, std::size_t a, std::size_t b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < som.weights().columns(); ++d) {
    const double difference = double{som.weights()(a, d)} - double{som.weights()(b, d)};
    sum = std::fma(difference, difference, sum);
  }
  return std::sqrt(sum);
}

}  // namespace

SomQuality measure_quality(const Som& som, const Samples& samples, std::size_t threads) {
  Samples storage;
  const std::vector<Winners> winners =
      WinnerSearch::find_all(som, seen_samples(som, samples, storage), true, threads);
  std::vector<double> distances(samples.count());
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = som.distance(samples[i], winners[i].first, workspace);
    }
  });
  SomQuality quality;
  quality.hits.resize(som.neurons());
  std::size_t torn = 0;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    quality.quantization_error += distances[i];
    quality.winners.push_back(winners[i].first);
    ++quality.hits[winners[i].first];
    if (som.neurons() > 1 && !som.grid().adjacent(winners[i].first, winners[i].second)) ++torn;
  }
  if (samples.count() == 0) return quality;
  const auto count = static_cast<double>(samples.count());
  quality.quantization_error /= count;
  quality.topographic_error = static_cast<double>(torn) / count;
  return quality;
}

std::vector<double> u_matrix(const Som& som) {
  std::vector<double> heights(som.neurons());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    const std::vector<std::size_t> neighbours = som.grid().neighbours(neuron);
    if (neighbours.empty()) continue;
    for (const std::size_t other : neighbours)
      heights[neuron] += weight_distance(som, neuron, other);
    heights[neuron] /= static_cast<double>(neighbours.size());
  }
  return heights;
}

std::vector<double> component_plane(const Som& som, std::size_t element) {
  require(element < som.input_size(), "component_plane: the map has no such input element");
  std::vector<double> plane(som.neurons());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    plane[neuron] = double{som.weight(neuron, element)};
  }
  return plane;
}

}  // namespace somato
