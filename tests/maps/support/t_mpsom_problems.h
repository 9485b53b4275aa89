#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/random.h"
#include "somato/maps/t_mpsom.h"

namespace somato::testing {

/// Inputs in the forms that tests have and the map takes.
inline std::vector<SignalView> views(const std::vector<Signal>& signals) {
  std::vector<SignalView> views;
  for (const Signal& signal : signals) views.push_back(signal.view());
  return views;
}

inline std::vector<Signal> dense(const std::vector<std::vector<float>>& inputs) {
  std::vector<Signal> signals;
  for (const auto& values : inputs) signals.push_back(Signal::dense(values));
  return signals;
}

inline std::vector<Signal> densified(const std::vector<Signal>& signals) {
  std::vector<Signal> all;
  for (const Signal& signal : signals) all.push_back(Signal::dense(signal.to_dense()));
  return all;
}

/// The map used and trained with a workspace of its own.
inline std::vector<float> activation(const TMpsom& map, const std::vector<Signal>& inputs) {
  TMpsom::Workspace workspace(map);
  std::vector<float> activity(map.neurons());
  map.activation(views(inputs), workspace, activity);
  return activity;
}

inline bool learn(TMpsom& map, const std::vector<Signal>& inputs, double alpha) {
  TMpsom::Workspace workspace(map);
  return map.learn(views(inputs), alpha, workspace);
}

inline double length(std::span<const float> values) {
  double squares = 0.0;
  for (const float value : values) squares += double{value} * double{value};
  return std::sqrt(squares);
}

inline double cosine(std::span<const float> a, std::span<const float> b) {
  double product = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) product += double{a[i]} * double{b[i]};
  return product / (length(a) * length(b));
}

/// The sign of random values.
enum class Sign { kPositive, kEither };

/// A small T-MPSOM of any kind, signals (zero, dense, sparse) and weights for it.
inline TMpsomParameters random_parameters(Random& random) {
  TMpsomParameters p;
  const std::size_t inputs = 1 + random.below(4);
  const std::size_t axes = 1 + random.below(inputs);
  for (std::size_t axis = 0; axis < axes; ++axis) p.shape.push_back(1 + random.below(6));
  for (std::size_t a = 0; a < inputs; ++a) {
    p.input_sizes.push_back(1 + random.below(9));
    p.input_axes.push_back(a < axes ? a : random.below(axes));
  }
  p.combination = random.below(2) ? TMpsomCombination::kMultiplied : TMpsomCombination::kAdded;
  p.arbor_sigma = 0.5 + 2.0 * random.uniform();
  p.neighbourhood_sigma = 1.0 + 2.0 * random.uniform();
  p.input_norm = random.below(3) ? TMpsomNorm::kL2 : TMpsomNorm::kNone;
  p.weight_norm = random.below(3) ? TMpsomNorm::kL2 : TMpsomNorm::kNone;
  p.seed = random.below(1000);
  return p;
}

inline float random_value(Random& random, Sign sign) {
  return static_cast<float>(sign == Sign::kEither ? random.normal() : random.uniform());
}

inline Signal random_signal(Random& random, std::size_t size, Sign sign) {
  std::vector<float> values(size);
  std::vector<std::uint32_t> indices;
  std::vector<float> stored;
  const bool is_zero = random.below(20) == 0;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (is_zero || random.below(3) == 0) continue;
    values[k] = random_value(random, sign);
    indices.push_back(k);
    stored.push_back(values[k]);
  }
  if (random.below(2)) return Signal::dense(values);
  return Signal::sparse({size}, indices, stored);
}

inline std::vector<Signal> random_inputs(Random& random, const TMpsomParameters& p, Sign sign) {
  std::vector<Signal> inputs;
  for (const std::size_t size : p.input_sizes) inputs.push_back(random_signal(random, size, sign));
  return inputs;
}

inline void scale_to_unit_length(std::span<float> values) {
  const double norm = length(values);
  if (norm == 0.0) return;
  for (float& value : values) value = static_cast<float>(value / norm);
}

inline std::vector<Matrix<float>> random_weights(Random& random, const TMpsomParameters& p,
                                                 Sign sign) {
  std::vector<Matrix<float>> all;
  for (const std::size_t size : p.input_sizes) {
    Matrix<float>& weights = all.emplace_back(p.neurons(), size);
    for (std::size_t n = 0; n < weights.rows(); ++n) {
      if (random.below(30) == 0) continue;  // a row of zeros
      for (float& weight : weights.row(n)) weight = random_value(random, sign);
      if (p.weight_norm == TMpsomNorm::kL2) scale_to_unit_length(weights.row(n));
    }
  }
  return all;
}

}  // namespace somato::testing
