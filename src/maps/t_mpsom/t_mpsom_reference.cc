#include "maps/t_mpsom/t_mpsom_reference.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/core/elementary.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

void normalize(std::span<double> values, TMpsomNorm norm) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  if (norm == TMpsomNorm::kNone || squares == 0.0) return;
  for (double& value : values) value /= std::sqrt(squares);
}

void check(const TMpsomParameters& parameters) {
  const Result<void> valid = parameters.validate();
  if (!valid) throw InvalidArgument(to_string(valid.error()));
}

std::vector<Matrix<double>> initial_weights(const TMpsomParameters& parameters) {
  std::vector<Matrix<double>> weights;
  std::uint32_t first = 0;
  for (const std::size_t size : parameters.input_sizes) {
    Matrix<double>& w = weights.emplace_back(parameters.neurons(), size);
    for (std::uint32_t n = 0; n < w.rows(); ++n) {
      for (std::uint32_t k = 0; k < size; ++k) {
        w(n, k) = uniform_at(parameters.seed, Stream::kInitialWeights, n, first + k);
      }
      normalize(w.row(n), parameters.weight_norm);
    }
    first += static_cast<std::uint32_t>(size);
  }
  return weights;
}

}  // namespace

TMpsomReference::TMpsomReference(TMpsomParameters parameters) : parameters_(std::move(parameters)) {
  check(parameters_);
  weights_ = initial_weights(parameters_);
}

TMpsomReference::TMpsomReference(TMpsomParameters parameters, std::vector<Matrix<double>> weights)
    : parameters_(std::move(parameters)), weights_(std::move(weights)) {
  check(parameters_);
  require(weights_.size() == parameters_.input_sizes.size(), "weights are required for each input");
  for (std::size_t a = 0; a < weights_.size(); ++a) {
    require(weights_[a].rows() == parameters_.neurons() &&
                weights_[a].columns() == parameters_.input_sizes[a],
            "weights of an input need one row per neuron and one column per element");
  }
}

double TMpsomReference::arbor(std::size_t input, std::size_t neuron, std::size_t element) const {
  const std::size_t axis = parameters_.axes()[input];
  const auto extent = static_cast<double>(parameters_.shape[axis]);
  const auto size = static_cast<double>(parameters_.input_sizes[input]);
  const auto u = static_cast<double>(1 + parameters_.place(neuron, axis));
  const auto v = static_cast<double>(1 + element);
  const double distance = u - extent / size * v;
  const double s = parameters_.arbor_sigma;
  return exponential(-(distance * distance) / (2.0 * s * s));
}

std::vector<double> TMpsomReference::activation(
    const std::vector<std::vector<double>>& inputs) const {
  require(inputs.size() == weights_.size(), "the number of inputs differs from that of the map");
  const bool multiplied = parameters_.combination == TMpsomCombination::kMultiplied;
  std::vector<double> activity(parameters_.neurons(), multiplied ? 1.0 : 0.0);
  for (std::size_t a = 0; a < inputs.size(); ++a) {
    require(inputs[a].size() == parameters_.input_sizes[a], "an input has the wrong size");
    std::vector<double> x = inputs[a];
    normalize(x, parameters_.input_norm);
    for (std::size_t n = 0; n < activity.size(); ++n) {
      double partial = 0.0;
      for (std::size_t k = 0; k < x.size(); ++k)
        partial += arbor(a, n, k) * weights_[a](n, k) * x[k];
      activity[n] = multiplied ? activity[n] * partial : activity[n] + partial;
    }
  }
  return activity;
}

std::vector<double> TMpsomReference::neighbourhood(const std::vector<double>& activity) const {
  const double sigma = parameters_.neighbourhood_sigma;
  std::vector<double> spread(activity.size(), 0.0);
  for (std::size_t n = 0; n < activity.size(); ++n) {
    for (std::size_t m = 0; m < activity.size(); ++m) {
      double squared_distance = 0.0;
      for (std::size_t axis = 0; axis < parameters_.shape.size(); ++axis) {
        const double apart = static_cast<double>(parameters_.place(n, axis)) -
                             static_cast<double>(parameters_.place(m, axis));
        squared_distance += apart * apart;
      }
      spread[n] +=
          std::max(activity[m], 0.0) * exponential(-squared_distance / (2.0 * sigma * sigma));
    }
  }
  const double maximum = *std::max_element(spread.begin(), spread.end());
  if (maximum <= 0.0) return std::vector<double>(spread.size(), 0.0);
  for (double& value : spread) value /= maximum;
  return spread;
}

bool TMpsomReference::learn(const std::vector<std::vector<double>>& inputs, double alpha) {
  const std::vector<double> gains = neighbourhood(activation(inputs));
  if (*std::max_element(gains.begin(), gains.end()) <= 0.0) return false;
  for (std::size_t a = 0; a < inputs.size(); ++a) {
    std::vector<double> x = inputs[a];
    normalize(x, parameters_.input_norm);
    for (std::size_t n = 0; n < gains.size(); ++n) {
      const std::span<double> w = weights_[a].row(n);
      for (std::size_t k = 0; k < x.size(); ++k) w[k] += alpha * gains[n] * (x[k] - w[k]);
      normalize(w, parameters_.weight_norm);
    }
  }
  return true;
}

}  // namespace somato
