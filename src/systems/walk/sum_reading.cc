#include "systems/walk/sum_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/kernels/kernels.h"
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
  require(follows(norm), "the largest element of a sum is not tracked");
  for (std::size_t place = 0; place < weights_.rows(); ++place) {
    const StoredElements& stored = som.elements();
    places_[stored.all() ? place : stored.listed()[place]] = static_cast<std::uint32_t>(place);
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      const float weight = som.weights()(neuron, place);
      weights_(place, neuron) = weight;
      squared_lengths_[neuron] += double{weight} * double{weight};
    }
  }
  greatest_length_ = std::sqrt(*std::max_element(squared_lengths_.begin(), squared_lengths_.end()));
}

void SumReading::start() {
  std::fill(sums_.begin(), sums_.end(), 0.0);
  std::fill(products_.begin(), products_.end(), 0.0);
  squared_length_ = 0.0;
  magnitude_ = 0.0;
}

void SumReading::add(const SignalView& frame) {
  require(frame.size == sums_.size(), "the size of a frame differs from the map's input size");
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

// The factor of the sum in the map's input. Zeros are unchanged.
double SumReading::factor() const {
  const double length = std::sqrt(std::max(0.0, squared_length_));
  const double norm = norm_ == Norm::kL1 ? magnitude_ : norm_ == Norm::kL2 ? length : 1.0;
  const double divisor = som_.parameters().normalize_input.value_or(false) ? length : norm;
  return divisor > 0.0 ? 1.0 / divisor : 1.0;
}

// A bound on the effect of rounding on the difference of two neurons' scores. The input of the map
// is x + d for the sum x, with |d| < 2^-21 |x|: its elements are rounded in the summation, in the
// division by the norm and in the normalization of the map. That changes the difference of two
// scores, 2 x . (v - w), by less than 2 |d| (|v| + |w|). Sums in double precision have much smaller
// errors.
double SumReading::margin(double factor) const {
  constexpr double kRounding = 0x1p-21;
  const double length = factor * std::sqrt(std::max(0.0, squared_length_));
  return 4.0 * kRounding * length * greatest_length_;
}

std::optional<std::size_t> SumReading::winner() const {
  const double scale = factor();
  const bool dot_product = som_.parameters().similarity == Similarity::kDotProduct;
  const auto score = [&](std::size_t neuron) {
    const double product = -2.0 * scale * products_[neuron];
    return dot_product ? product : squared_lengths_[neuron] + product;
  };
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  double next = least;
  for (std::size_t neuron = 0; neuron < products_.size(); ++neuron) {
    const double value = score(neuron);
    if (value >= next) continue;
    next = std::max(value, least);
    if (value >= least) continue;
    least = value;
    best = neuron;
  }
  if (next - least <= margin(scale)) return {};
  return best;
}

}  // namespace somato
