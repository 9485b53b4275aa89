#include "maps/grid/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/core/elementary.h"
#include "base/kernels/product_kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// A neuron at exactly the radius is within it, regardless of the rounding of sqrt(3)/2.
constexpr double kRadiusTolerance = 1e-9;

// Smaller factors become 0: they are too small to move a weight, and numbers near the end of a
// type's range (denormal ones) slow the arithmetic down. In double precision, where factors may
// also be weights of a mean, only that end itself is cut off.
template <typename Real>
constexpr double kSmallestFactor = sizeof(Real) == sizeof(float) ? 0x1p-100 : 0x1p-1000;

// The exponent of the Gaussian.
double exponent(double difference, double radius) {
  if (difference == 0.0) return 0.0;
  if (radius == 0.0) return -std::numeric_limits<double>::infinity();
  const double ratio = difference / radius;
  return -0.5 * ratio * ratio;
}

// The square of distance / radius, so that 1 is the radius; radius 0 is only reached by distance 0.
double relative_square(double squared_distance, double radius) {
  if (squared_distance == 0.0) return 0.0;
  const double limit = radius * radius;
  if (limit == 0.0) return std::numeric_limits<double>::infinity();
  const double square = squared_distance / limit;
  return std::fabs(square - 1.0) <= kRadiusTolerance ? 1.0 : square;
}

// The function of the square of distance / radius, for the shapes that are neither a product of
// rows and columns nor constant.
double factor_of(NeighbourhoodShape shape, double square) {
  if (square == 0.0) return 1.0;
  if (shape == NeighbourhoodShape::kMexicanHat) {
    const double factor = exponential(-0.5 * square);
    return factor == 0.0 ? 0.0 : (1.0 - square) * factor;
  }
  if (square > 1.0) return 0.0;
  if (shape == NeighbourhoodShape::kTriangular) return 1.0 - std::sqrt(square);
  if (shape == NeighbourhoodShape::kEpanechnikov) return 1.0 - square;
  return exponential(-0.5 * square);
}

template <typename Real>
Real without_smallest(double factor) {
  return std::fabs(factor) < kSmallestFactor<Real> ? Real{0} : static_cast<Real>(factor);
}

}  // namespace

double gaussian_factor(double difference, double radius) {
  const double factor = exponential(exponent(difference, radius));
  return factor < kSmallestFactor<double> ? 0.0 : factor;
}

Neighbourhood::Neighbourhood(const Grid& grid, NeighbourhoodShape shape)
    : grid_(grid), shape_(shape), row_factors_(grid.rows()), column_factors_(2 * grid.columns()) {
  const std::size_t columns = grid.columns();
  vertical_.reserve(grid.rows());
  horizontal_.reserve(3 * (2 * columns - 1));
  for (std::size_t r = 0; r < grid.rows(); ++r) {
    vertical_.push_back(grid.vertical_difference(r, 0));
  }
  for (const auto& [parity, other] : {std::pair{0U, 1U}, {0U, 0U}, {1U, 0U}}) {
    for (std::size_t left = columns - 1; left > 0; --left) {
      horizontal_.push_back(grid.horizontal_difference(0, parity, left, other));
    }
    for (std::size_t right = 0; right < columns; ++right) {
      horizontal_.push_back(grid.horizontal_difference(right, parity, 0, other));
    }
  }
}

void Neighbourhood::around(std::size_t winner, double radius, std::span<float> out) {
  write_around(winner, radius, out);
}

void Neighbourhood::around(std::size_t winner, double radius, std::span<double> out) {
  write_around(winner, radius, out);
}

void Neighbourhood::prepare_factors(std::size_t winner, double radius) {
  const std::size_t row = grid_.row_of(winner);
  const std::size_t column = grid_.column_of(winner);
  const std::size_t columns = grid_.columns();
  for (std::size_t r = 0; r < grid_.rows(); ++r) {
    row_factors_[r] = exponent(vertical_[r > row ? r - row : row - r], radius);
  }
  // On a rectangular grid rows of both parities have the same factors.
  const bool hexagonal = grid_.lattice() == Lattice::kHexagonal;
  const std::size_t parities = hexagonal ? 2 : 1;
  for (std::size_t parity = 0; parity < parities; ++parity) {
    const std::size_t shift = hexagonal ? 1 + parity - row % 2 : 1;
    const double* differences = &horizontal_[shift * (2 * columns - 1) + columns - 1 - column];
    for (std::size_t c = 0; c < columns; ++c) {
      column_factors_[parity * columns + c] = exponent(differences[c], radius);
    }
  }
  const auto& kernels = kernels::product_table();
  kernels.exponentials(row_factors_.data(), row_factors_.size());
  kernels.exponentials(column_factors_.data(), parities * columns);
}

template <typename Real>
void Neighbourhood::write_around(std::size_t winner, double radius, std::span<Real> out) {
  require(out.size() >= grid_.size(), "the neighbourhood needs space for one value per neuron");
  if (shape_ == NeighbourhoodShape::kBubble) {
    const double limit = radius * radius * (1.0 + kRadiusTolerance);
    for (std::size_t neuron = 0; neuron < grid_.size(); ++neuron) {
      out[neuron] = grid_.squared_distance(winner, neuron) <= limit ? Real{1} : Real{0};
    }
    return;
  }
  if (shape_ != NeighbourhoodShape::kGaussian) return write_by_distance(winner, radius, out);
  prepare_factors(winner, radius);
  for (std::size_t row = 0; row < grid_.rows(); ++row) {
    const std::size_t parity = grid_.lattice() == Lattice::kHexagonal ? row % 2 : 0;
    const double* factors = column_factors_.data() + parity * grid_.columns();
    for (std::size_t column = 0; column < grid_.columns(); ++column) {
      out[row * grid_.columns() + column] =
          without_smallest<Real>(row_factors_[row] * factors[column]);
    }
  }
}

template <typename Real>
void Neighbourhood::write_by_distance(std::size_t winner, double radius,
                                      std::span<Real> out) const {
  for (std::size_t neuron = 0; neuron < grid_.size(); ++neuron) {
    const double square = relative_square(grid_.squared_distance(winner, neuron), radius);
    out[neuron] = without_smallest<Real>(factor_of(shape_, square));
  }
}

}  // namespace somato
