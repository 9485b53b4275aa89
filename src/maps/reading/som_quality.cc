#include "somato/maps/som_quality.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "maps/reading/known_elements.h"
#include "maps/reading/sample_reader.h"
#include "somato/core/check.h"

namespace somato {
namespace {

double weight_distance(const Som& som, std::size_t a, std::size_t b) {
  std::vector<float> of_a(som.weights().columns());
  std::vector<float> of_b(of_a.size());
  som.weights().copy_row(a, of_a);
  som.weights().copy_row(b, of_b);
  return distance_between(som.parameters(), of_a, of_b);
}

}  // namespace

SomQualityMeasurement::SomQualityMeasurement(const Som& som, std::size_t threads, bool keeps)
    : som_(som), threads_(threads), keeps_(keeps), hits_(som.neurons()) {}

std::vector<std::size_t> SomQualityMeasurement::add(const Samples& samples) {
  const auto [winners, distances, _] = SampleReader(som_, threads_).read(samples, {true, true});
  std::vector<std::size_t> first;
  first.reserve(samples.count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    distances_ += distances[i];
    first.push_back(winners[i].first);
    ++hits_[winners[i].first];
    if (som_.neurons() > 1 && !som_.grid().adjacent(winners[i].first, winners[i].second))
      ++topographic_errors_;
  }
  samples_ += samples.count();
  if (keeps_) kept_.insert(kept_.end(), distances.begin(), distances.end());
  return first;
}

void SomQualityMeasurement::combine(ProcessGroup& processes) {
  require(keeps_, "a measurement must keep distances to be combined");
  distances_ = processes.in_turn(
      0.0, [&](double sum) { return std::accumulate(kept_.begin(), kept_.end(), sum); });
  std::vector<std::int64_t> counts(hits_.begin(), hits_.end());
  counts.push_back(static_cast<std::int64_t>(samples_));
  counts.push_back(static_cast<std::int64_t>(topographic_errors_));
  processes.sum(counts);
  topographic_errors_ = static_cast<std::size_t>(counts[hits_.size() + 1]);
  samples_ = static_cast<std::size_t>(counts[hits_.size()]);
  std::transform(counts.begin(), counts.end() - 2, hits_.begin(),
                 [](std::int64_t count) { return static_cast<std::size_t>(count); });
}

SomQuality SomQualityMeasurement::quality() const {
  SomQuality quality;
  quality.hits = hits_;
  if (samples_ == 0) return quality;
  const auto count = static_cast<double>(samples_);
  quality.quantization_error = distances_ / count;
  quality.topographic_error = static_cast<double>(topographic_errors_) / count;
  return quality;
}

SomQuality measure_quality(const Som& som, const Samples& samples, std::size_t threads) {
  SomQualityMeasurement measurement(som, threads);
  std::vector<std::size_t> winners = measurement.add(samples);
  SomQuality quality = measurement.quality();
  quality.winners = std::move(winners);
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

std::vector<double> edge_distances(const Som& som) {
  std::vector<double> distances;
  if (!som.grid().graph()) return distances;
  const std::vector<NeuronGraph::Edge>& edges = som.grid().graph()->edges();
  distances.reserve(edges.size());
  for (const auto& [a, b] : edges) distances.push_back(weight_distance(som, a, b));
  return distances;
}

double neuron_distance(const Som& som, std::size_t first, std::size_t second) {
  require(first < som.neurons() && second < som.neurons(), "the neuron is not on the map");
  return weight_distance(som, first, second);
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
