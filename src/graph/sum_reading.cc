#include "graph/sum_reading.h"

#include <algorithm>
#include <cmath>

#include "core/kernels.h"
#include "maps/activity.h"
#include "somato/core/check.h"

// With the sum m, its factor f = 1 / |m| and the weights w of a neuron,
//
//     |f m - w|^2 = f^2 m . m - 2 f m . w + w . w,
//
// and a frame with the value v at element e adds v w_e to m . w and v (2 m_e + v) to m . m.

namespace somato {

bool SumReading::follows(Norm norm) {
  return norm != Norm::kMaximum;
}

SumReading::SumReading(const Som& som, Norm norm)
    : som_(som),
      norm_(norm),
      weights_(som.elements().count(), som.neurons()),
      squared_lengths_(som.neurons()),
      places_(som.input_size(), static_cast<std::uint32_t>(som.elements().count())),
      sums_(som.input_size()),
      products_(som.neurons()) {
  require(follows(norm), "the largest element of a sum is not followed");
  for (std::size_t place = 0; place < weights_.rows(); ++place) {
    const StoredElements& stored = som.elements();
    places_[stored.all() ? place : stored.listed()[place]] = static_cast<std::uint32_t>(place);
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      const float weight = som.weights()(neuron, place);
      weights_(place, neuron) = weight;
      squared_lengths_[neuron] += double{weight} * double{weight};
    }
  }
}

void SumReading::start() {
  std::fill(sums_.begin(), sums_.end(), 0.0);
  std::fill(products_.begin(), products_.end(), 0.0);
  squared_length_ = 0.0;
  magnitude_ = 0.0;
}

void SumReading::add(const SignalView& frame) {
  require(frame.size == sums_.size(), "a frame has another size than the map's input");
  for (std::size_t i = 0; i < frame.values.size(); ++i) {
    add_element(frame.sparse ? frame.indices[i] : i, double{frame.values[i]});
  }
}

void SumReading::add_element(std::size_t element, double value) {
  const double before = sums_[element];
  sums_[element] += value;
  squared_length_ += value * (2.0 * before + value);
  magnitude_ += std::fabs(sums_[element]) - std::fabs(before);
  if (places_[element] == weights_.rows()) return;
  kernels::table<float>().add_scaled(weights_.row(places_[element]).data(), value, products_.size(),
                                     products_.data());
}

// What the sum is multiplied by before the map sees it. Zeros stay.
double SumReading::factor() const {
  const double length = std::sqrt(std::max(0.0, squared_length_));
  const double norm = norm_ == Norm::kL1 ? magnitude_ : norm_ == Norm::kL2 ? length : 1.0;
  const double divisor = som_.parameters().normalize_input.value_or(false) ? length : norm;
  return divisor > 0.0 ? 1.0 / divisor : 1.0;
}

// Rounding may leave a difference of equals below 0.
double SumReading::squared_distance(std::size_t neuron, double factor) const {
  const double of_sum = factor * factor * squared_length_ - 2.0 * factor * products_[neuron];
  return std::max(0.0, of_sum + squared_lengths_[neuron]);
}

// The least is the most similar.
double SumReading::score(std::size_t neuron, double factor) const {
  const bool dot_product = som_.parameters().similarity == Similarity::kDotProduct;
  return dot_product ? -factor * products_[neuron]
                     : squared_lengths_[neuron] - 2.0 * factor * products_[neuron];
}

std::size_t SumReading::winner() const {
  const double scale = factor();
  std::size_t best = 0;
  double least = score(0, scale);
  for (std::size_t neuron = 1; neuron < products_.size(); ++neuron) {
    const double value = score(neuron, scale);
    if (value >= least) continue;
    least = value;
    best = neuron;
  }
  return best;
}

std::size_t SumReading::winner_among(std::span<const std::size_t> candidates) const {
  require(!candidates.empty(), "winner_among needs at least one candidate");
  const double scale = factor();
  std::size_t best = candidates.front();
  for (const std::size_t neuron : candidates) {
    require(neuron < products_.size(), "winner_among: no such neuron");
    if (score(neuron, scale) < score(best, scale)) best = neuron;
  }
  return best;
}

double SumReading::distance(std::size_t neuron) const {
  require(neuron < products_.size(), "there is no such neuron");
  return std::sqrt(squared_distance(neuron, factor()));
}

void SumReading::activity(std::span<float> out) const {
  require(out.size() == products_.size(), "an activity needs room for a value a neuron");
  const double scale = factor();
  const bool dot_product = som_.parameters().similarity == Similarity::kDotProduct;
  for (std::size_t neuron = 0; neuron < out.size(); ++neuron) {
    out[neuron] = dot_product ? static_cast<float>(scale * products_[neuron])
                              : similarity_at(squared_distance(neuron, scale));
  }
  activity_of_similarities(som_.parameters(), out);
}

}  // namespace somato
