#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/random.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato::testing {

/// Points around a few centres, in random order.
inline Samples clustered_samples(std::size_t count, std::size_t size, std::uint64_t seed) {
  constexpr std::size_t kCentres = 4;
  Random random(seed);
  Matrix<double> centres(kCentres, size);
  for (double& value : centres.values()) value = 6.0 * random.uniform();
  Matrix<float> points(count, size);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t centre = random.below(kCentres);
    for (std::size_t d = 0; d < size; ++d) {
      points(i, d) = static_cast<float>(centres(centre, d) + random.normal());
    }
  }
  return Samples(std::move(points));
}

/// Vectors as plain lists, for slow references.
using Values = std::vector<double>;

inline Values point_of(const Samples& samples, std::size_t sample) {
  std::vector<float> values(samples.size());
  write_dense(samples[sample], values);
  return {values.begin(), values.end()};
}

inline double distance(const Values& a, const Values& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The neuron nearest to `x`, `except` one.
inline std::size_t nearest(const std::vector<Values>& weights, const Values& x,
                           std::size_t except = std::numeric_limits<std::size_t>::max()) {
  std::size_t best = except == 0 ? 1 : 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (i != except && distance(weights[i], x) < distance(weights[best], x)) best = i;
  }
  return best;
}

/// w += rate (x - w)
inline void move(Values& w, const Values& x, double rate) {
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += rate * (x[i] - w[i]);
}

inline Values mean(const Values& a, const Values& b) {
  Values middle(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) middle[i] = (a[i] + b[i]) / 2.0;
  return middle;
}

/// The weights of a map's neurons.
inline std::vector<Values> points_of(const Som& som) {
  std::vector<Values> points(som.neurons());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t d = 0; d < som.input_size(); ++d) {
      points[neuron].push_back(double{som.weight(neuron, d)});
    }
  }
  return points;
}

/// The greatest difference of two lists of points; infinite if their sizes differ.
inline double difference(const std::vector<Values>& a, const std::vector<Values>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, distance(a[i], b[i]));
  return greatest;
}

}  // namespace somato::testing
