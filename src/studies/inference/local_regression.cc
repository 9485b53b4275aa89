#include "studies/inference/local_regression.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

// A column whose remaining length is a smaller part of its length consists of rounding.
constexpr double kRemaining = 1e-9;

double inner_product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

LocalRegression::LocalRegression(Matrix<double> predictors, std::span<const double> weights)
    : predictors_(std::move(predictors)) {
  require(weights.size() == predictors_.rows(), "each row of predictors has a weight");
  for (const double weight : weights) roots_.push_back(std::sqrt(weight));
  const std::size_t columns = predictors_.columns() + 1;
  triangle_ = Matrix<double>(columns, columns);
  for (std::size_t column = 0; column < columns; ++column)
    directions_.push_back(direction_of(column));
}

std::vector<double> LocalRegression::direction_of(std::size_t column) {
  std::vector<double> rest = roots_;
  for (std::size_t i = 0; column > 0 && i < rest.size(); ++i) rest[i] *= predictors_(i, column - 1);
  const double length = std::sqrt(inner_product(rest, rest));
  for (std::size_t before = 0; before < column; ++before) {
    const std::vector<double>& direction = directions_[before];
    if (direction.empty()) continue;
    const double part = inner_product(direction, rest);
    triangle_(before, column) = part;
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= part * direction[i];
  }
  const double remaining = std::sqrt(inner_product(rest, rest));
  if (!(remaining > kRemaining * length)) return {};
  triangle_(column, column) = remaining;
  for (double& value : rest) value /= remaining;
  return rest;
}

std::vector<double> LocalRegression::coefficients(std::span<const double> values) const {
  require(values.size() == roots_.size(), "each row of predictors has a value");
  std::vector<double> rest = roots_;
  for (std::size_t i = 0; i < values.size(); ++i) rest[i] *= values[i];
  std::vector<double> parts(directions_.size(), 0.0);
  for (std::size_t column = 0; column < parts.size(); ++column) {
    const std::vector<double>& direction = directions_[column];
    if (direction.empty()) continue;
    parts[column] = inner_product(direction, rest);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= parts[column] * direction[i];
  }
  for (std::size_t column = parts.size(); column-- > 0;) {
    if (directions_[column].empty()) continue;
    for (std::size_t later = column + 1; later < parts.size(); ++later) {
      parts[column] -= triangle_(column, later) * parts[later];
    }
    parts[column] /= triangle_(column, column);
  }
  return {parts.begin() + 1, parts.end()};
}

void LocalRegression::adjust(std::span<double> values) const {
  const std::vector<double> found = coefficients(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= inner_product(found, predictors_.row(i));
}

}  // namespace somato
