#include "studies/lifelong/replayed_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Point = std::vector<float>;

double squared_distance_of(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = double{a[i]} - double{b[i]};
    sum = std::fma(difference, difference, sum);
  }
  return sum;
}

std::vector<Point> points_of(const Samples& samples, const Numbers& numbers) {
  std::vector<Point> points(numbers.size(), Point(samples.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) write_dense(samples[numbers[i]], points[i]);
  return points;
}

Point mean_of(const std::vector<Point>& points) {
  Point mean(points.front().size());
  for (std::size_t d = 0; d < mean.size(); ++d) {
    double sum = 0.0;
    for (const Point& point : points) sum += double{point[d]};
    mean[d] = static_cast<float>(sum / static_cast<double>(points.size()));
  }
  return mean;
}

// The places of the points in the order of their distance from the mean.
Numbers nearest_to_mean(const std::vector<Point>& points) {
  const Point mean = mean_of(points);
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.emplace_back(squared_distance_of(points[i], mean), i);
  }
  std::sort(order.begin(), order.end());
  Numbers places;
  places.reserve(order.size());
  for (const auto& [distance, place] : order) places.push_back(place);
  return places;
}

// Begins with the point nearest to the mean; next is the point that is most distant from the
// nearest one before it (Gonzalez, Theoretical Computer Science 38, 1985).
Numbers most_distant(const std::vector<Point>& points) {
  Numbers places{nearest_to_mean(points).front()};
  std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
  while (places.size() < points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances[i] = std::min(distances[i], squared_distance_of(points[i], points[places.back()]));
    }
    for (const std::size_t place : places) distances[place] = -1.0;
    const auto next = std::max_element(distances.begin(), distances.end());
    places.push_back(static_cast<std::size_t>(next - distances.begin()));
  }
  return places;
}

Numbers order_of(ReplayChoice choice, const Samples& samples, const Numbers& candidates,
                 Random& random) {
  switch (choice) {
    case ReplayChoice::kRandom:
      return random_order(candidates.size(), random);
    case ReplayChoice::kNearestToMean:
      return nearest_to_mean(points_of(samples, candidates));
    case ReplayChoice::kMostDistant:
      return most_distant(points_of(samples, candidates));
    case ReplayChoice::kFirst:
      break;
  }
  Numbers places(candidates.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

Point weights_of(const Som& som, std::size_t neuron) {
  Point weights(som.input_size());
  for (std::size_t d = 0; d < weights.size(); ++d) weights[d] = som.weight(neuron, d);
  return weights;
}

double distance_from_others(const Som& som, std::size_t neuron, const Point& weights) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < som.neurons(); ++other) {
    if (other == neuron) continue;
    nearest = std::min(nearest, squared_distance_of(weights, weights_of(som, other)));
  }
  return som.neurons() > 1 ? std::sqrt(nearest) : 0.0;
}

}  // namespace

Numbers choose_samples(ReplayChoice choice, std::size_t count, const Samples& samples,
                       const Numbers& candidates, Random& random) {
  if (count == 0 || candidates.empty()) return {};
  Numbers chosen = order_of(choice, samples, candidates, random);
  chosen.resize(std::min(count, chosen.size()));
  for (std::size_t& place : chosen) place = candidates[place];
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Matrix<float> generated_vectors(std::size_t count, double spread, const Som& som,
                                const NeuronVotes& votes, std::size_t the_class, Random& random) {
  Matrix<float> vectors(0, som.input_size());
  const NeuronLabels labels = votes.labels();
  Numbers urn;  // each neuron as often as its votes
  for (const std::size_t neuron : labels.labelled()) {
    if (labels[neuron] == the_class) urn.insert(urn.end(), votes.of(neuron, the_class), neuron);
  }
  for (std::size_t i = 0; i < count && !urn.empty(); ++i) {
    const std::size_t neuron = urn[random.below(urn.size())];
    const Point weights = weights_of(som, neuron);
    const double deviation = spread * distance_from_others(som, neuron, weights) /
                             std::sqrt(static_cast<double>(weights.size()));
    const std::span<float> vector = vectors.add_row();
    for (std::size_t d = 0; d < weights.size(); ++d) {
      vector[d] = static_cast<float>(double{weights[d]} + deviation * random.normal());
    }
  }
  return vectors;
}

}  // namespace somato
