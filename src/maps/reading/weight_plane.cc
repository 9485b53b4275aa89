#include "maps/reading/weight_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/grid/feature_ranges.h"
#include "maps/reading/winner_search.h"

namespace somato {
namespace {

Samples samples_of(const LaneMatrix<float>& weights, std::size_t most) {
  const std::size_t count = std::min(weights.rows(), most);
  Matrix<float> rows(count, weights.columns());
  for (std::size_t i = 0; i < count; ++i) {
    weights.copy_row(i * weights.rows() / count, rows.row(i));
  }
  return Samples(std::move(rows));
}

// As many as check_plane() accepts.
std::size_t neurons_of_plane(const LaneMatrix<float>& weights) {
  return weights.columns() > kMostRowsOfPlane ? kMostRowsOfPlane : weights.rows();
}

double length_of(const std::vector<double>& vector) {
  double sum = 0.0;
  for (const double value : vector) sum = std::fma(value, value, sum);
  return std::sqrt(sum);
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = std::fma(a[i], b[i], sum);
  return sum;
}

// The mean squared distance from the mean.
double variance_of(const Samples& rows, const std::vector<double>& mean) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.count(); ++i) {
    for (std::size_t d = 0; d < mean.size(); ++d) {
      const double apart = double{rows[i].values[d]} - mean[d];
      sum = std::fma(apart, apart, sum);
    }
  }
  return sum / static_cast<double>(rows.count());
}

}  // namespace

WeightPlane::WeightPlane(const Som& som) {
  const Samples some = samples_of(som.weights(), neurons_of_plane(som.weights()));
  std::vector<float> low;
  std::vector<float> high;
  widen_ranges(some, low, high);
  PrincipalPlane plane = principal_plane(some, low, high);
  const double variance = variance_of(some, plane.mean);
  axes_ = {std::move(plane.first), std::move(plane.second)};
  for (std::size_t i = 0; i < 2; ++i) {
    const double deviation = length_of(axes_[i]);
    if (deviation > 0.0) {
      shares_[i] = std::min(deviation * deviation / variance, 1.0);
      for (double& value : axes_[i]) value /= deviation;
    }
    of_mean_[i] = dot(plane.mean, axes_[i]);
  }
  const Samples all = samples_of(som.weights(), som.neurons());
  for (std::size_t n = 0; n < all.count(); ++n) neurons_.push_back(position(all[n]));
}

Position WeightPlane::position(const SignalView& vector) const {
  Position at{-of_mean_[0], -of_mean_[1]};
  for (std::size_t k = 0; k < vector.values.size(); ++k) {
    const std::size_t d = vector.sparse ? vector.indices[k] : k;
    at.x = std::fma(double{vector.values[k]}, axes_[0][d], at.x);
    at.y = std::fma(double{vector.values[k]}, axes_[1][d], at.y);
  }
  return at;
}

std::vector<Position> WeightPlane::positions_of(const Som& som, const Samples& samples) const {
  Samples storage;
  const Samples& seen = seen_samples(som, samples, storage);
  std::vector<Position> positions;
  positions.reserve(seen.count());
  for (std::size_t i = 0; i < seen.count(); ++i) positions.push_back(position(seen[i]));
  return positions;
}

}  // namespace somato
