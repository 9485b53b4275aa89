#include "maps/training/som_reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/core/elementary.h"
#include "maps/som/initial_weights.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

void to_length_one(std::span<double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  if (sum == 0.0) return;
  for (double& value : values) value /= std::sqrt(sum);
}

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += a[d] * b[d];
  return sum;
}

}  // namespace

ReferenceSom::ReferenceSom(SomParameters parameters, Matrix<double> weights)
    : parameters_(std::move(parameters)), grid_(parameters_.grid()), weights_(std::move(weights)) {}

ReferenceSom ReferenceSom::initial(const SomParameters& parameters, const Samples& samples) {
  Samples storage;
  const InitialWeightsSource source(parameters, prepared_samples(parameters, samples, storage));
  Matrix<double> weights(parameters.grid().size(), samples.size());
  std::vector<float> row(samples.size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    source.write(neuron, row);
    std::copy(row.begin(), row.end(), weights.row(neuron).begin());
  }
  return {parameters, std::move(weights)};
}

ReferenceSom ReferenceSom::trained(const SomParameters& parameters, const Samples& samples) {
  ReferenceSom som = initial(parameters, samples);
  const std::vector<std::vector<double>> inputs = som.inputs(samples);
  DrawSequence draws(parameters.draws, samples.count(), parameters.seed);
  for (std::uint64_t step = 0; step < parameters.steps(); ++step) {
    const double radius = parameters.radius().at(step);
    if (parameters.training == Training::kBatch) {
      som.learn_batch(inputs, radius);
    } else {
      som.learn(inputs[draws.next()], parameters.learning_rate().at(step), radius);
    }
  }
  return som;
}

double ReferenceSom::score(std::span<const double> input, std::size_t neuron) const {
  switch (parameters_.similarity) {
    case Similarity::kEuclidean:
      break;
    case Similarity::kDotProduct:
      return product(input, weights_.row(neuron));
    case Similarity::kManhattan:
    case Similarity::kCosine:
    case Similarity::kChebyshev:
      return distance(input, neuron);
  }
  const auto w = weights_.row(neuron);
  double sum = 0.0;
  for (std::size_t d = 0; d < input.size(); ++d) sum += (input[d] - w[d]) * (input[d] - w[d]);
  return sum;
}

std::size_t ReferenceSom::winner(std::span<const double> input) const {
  std::size_t best = 0;
  for (std::size_t neuron = 1; neuron < weights_.rows(); ++neuron) {
    const double difference = score(input, neuron) - score(input, best);
    if (parameters_.similarity == Similarity::kDotProduct ? difference > 0 : difference < 0) {
      best = neuron;
    }
  }
  return best;
}

double ReferenceSom::neighbourhood(std::size_t winner, std::size_t neuron, double radius) const {
  if (winner == neuron) return 1.0;
  if (radius == 0.0) return 0.0;
  const double distance = std::sqrt(grid_.squared_distance(winner, neuron));
  const bool within = distance <= radius * (1.0 + 1e-9);
  const double gaussian = exponential(-distance * distance / (2.0 * radius * radius));
  const double ratio = distance / radius;
  switch (parameters_.neighbourhood) {
    case NeighbourhoodShape::kGaussian:
      return gaussian;
    case NeighbourhoodShape::kBubble:
      return within ? 1.0 : 0.0;
    case NeighbourhoodShape::kCutGaussian:
      return within ? gaussian : 0.0;
    case NeighbourhoodShape::kTriangular:
      return std::max(0.0, 1.0 - ratio);
    case NeighbourhoodShape::kEpanechnikov:
      return std::max(0.0, 1.0 - ratio * ratio);
    case NeighbourhoodShape::kMexicanHat:
      return (1.0 - ratio * ratio) * gaussian;
  }
  return 0.0;
}

double ReferenceSom::distance(std::span<const double> input, std::size_t neuron) const {
  const auto w = weights_.row(neuron);
  if (parameters_.similarity == Similarity::kCosine) {
    const double lengths = std::sqrt(product(input, input)) * std::sqrt(product(w, w));
    return lengths == 0.0 ? 1.0 : 1.0 - product(input, w) / lengths;
  }
  double sum = 0.0;
  double most = 0.0;
  double squares = 0.0;
  for (std::size_t d = 0; d < input.size(); ++d) {
    const double apart = std::fabs(input[d] - w[d]);
    sum += apart;
    most = std::max(most, apart);
    squares += apart * apart;
  }
  if (parameters_.similarity == Similarity::kManhattan) return sum;
  return parameters_.similarity == Similarity::kChebyshev ? most : std::sqrt(squares);
}

std::vector<double> ReferenceSom::activity(std::span<const double> input) const {
  const double m = parameters_.softmax_exponent;
  std::vector<double> activity;
  for (std::size_t neuron = 0; neuron < weights_.rows(); ++neuron) {
    const double similarity = parameters_.similarity == Similarity::kDotProduct
                                  ? std::max(0.0, score(input, neuron))
                                  : 1.0 / (1.0 + distance(input, neuron));
    activity.push_back(parameters_.softmax == Softmax::kPower ? power(similarity, m)
                                                              : exponential(m * similarity));
  }
  double divisor = 0.0;
  for (const double value : activity) {
    divisor = parameters_.activity_norm == ActivityNorm::kSum ? divisor + value
                                                              : std::max(divisor, value);
  }
  if (divisor == 0.0) return activity;
  for (double& value : activity) value /= divisor;
  return activity;
}

void ReferenceSom::learn(std::span<const double> input, double learning_rate, double radius) {
  learn_at(winner(input), input, learning_rate, radius);
}

void ReferenceSom::learn_at(std::size_t winner, std::span<const double> input, double learning_rate,
                            double radius) {
  for (std::size_t neuron = 0; neuron < weights_.rows(); ++neuron) {
    const double gain = learning_rate * neighbourhood(winner, neuron, radius);
    for (std::size_t d = 0; d < input.size(); ++d) {
      weights_(neuron, d) += gain * (input[d] - weights_(neuron, d));
    }
  }
  normalize_weights();
}

void ReferenceSom::learn_batch(const std::vector<std::vector<double>>& inputs, double radius) {
  std::vector<std::size_t> winners;
  winners.reserve(inputs.size());
  for (const auto& input : inputs) winners.push_back(winner(input));
  for (std::size_t neuron = 0; neuron < weights_.rows(); ++neuron) {
    double total = 0.0;
    std::vector<double> sum(weights_.columns());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double gain = neighbourhood(winners[i], neuron, radius);
      total += gain;
      for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += gain * inputs[i][d];
    }
    if (total == 0.0) continue;
    for (std::size_t d = 0; d < sum.size(); ++d) weights_(neuron, d) = sum[d] / total;
  }
  normalize_weights();
}

std::vector<std::vector<double>> ReferenceSom::inputs(const Samples& samples) const {
  std::vector<std::vector<double>> inputs;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    std::vector<float> values(samples.size());
    write_dense(samples[i], values);
    inputs.emplace_back(values.begin(), values.end());
    if (parameters_.normalize_input.value_or(false)) to_length_one(inputs.back());
  }
  return inputs;
}

void ReferenceSom::normalize_weights() {
  if (parameters_.similarity != Similarity::kDotProduct) return;
  for (std::size_t neuron = 0; neuron < weights_.rows(); ++neuron) {
    to_length_one(weights_.row(neuron));
  }
}

}  // namespace somato
