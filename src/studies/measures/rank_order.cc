#include "studies/measures/rank_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/core/rank_correlation.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// Tolerance for values that are equal up to rounding.
constexpr double kRankRounding = 1e-12;

constexpr int kMostSquarings = 60;

double trace_of(const Matrix<double>& matrix) {
  double trace = 0.0;
  for (std::size_t i = 0; i < matrix.rows(); ++i) trace += matrix(i, i);
  return trace;
}

// The inner products of the vectors after subtracting their mean.
Matrix<double> centred(const Matrix<double>& inner_products) {
  const std::size_t count = inner_products.rows();
  std::vector<double> row_means(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const double product : inner_products.row(i)) row_means[i] += product;
    row_means[i] /= static_cast<double>(count);
  }
  const double mean = std::accumulate(row_means.begin(), row_means.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(count, 1));
  Matrix<double> left = inner_products;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) left(i, j) += mean - row_means[i] - row_means[j];
  }
  return left;
}

void scale(Matrix<double>& matrix, double factor) {
  for (double& value : matrix.values()) value *= factor;
}

Matrix<double> squared(const Matrix<double>& matrix) {
  Matrix<double> square(matrix.rows(), matrix.rows());
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (std::size_t k = 0; k < matrix.rows(); ++k) {
      for (std::size_t j = 0; j < matrix.rows(); ++j) {
        square(i, j) += matrix(i, k) * matrix(k, j);
      }
    }
  }
  return square;
}

// A matrix of trace 1, squared until only its largest eigenvalue remains.
Matrix<double> only_largest(Matrix<double> matrix) {
  for (int squaring = 0; squaring < kMostSquarings; ++squaring) {
    matrix = squared(matrix);
    const double trace = trace_of(matrix);
    scale(matrix, 1.0 / trace);
    if (trace >= 1.0 - kRankRounding) break;
  }
  return matrix;
}

double mean_order(const std::vector<OrderedGroup>& groups) {
  double sum = 0.0;
  for (const OrderedGroup& group : groups) {
    sum += std::abs(rank_correlation(group.numbers, group.positions));
  }
  return sum / static_cast<double>(groups.size());
}

}  // namespace

std::vector<double> principal_positions(const Matrix<double>& inner_products) {
  const std::size_t count = inner_products.rows();
  Matrix<double> products = centred(inner_products);
  const double trace = trace_of(products);
  if (!(trace > kRankRounding * trace_of(inner_products))) return std::vector<double>(count, 0.0);
  scale(products, 1.0 / trace);
  products = only_largest(std::move(products));
  // Every column points there; the longest is furthest from rounding.
  std::size_t longest = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (products(i, i) > products(longest, longest)) longest = i;
  }
  const auto row = products.row(longest);
  return {row.begin(), row.end()};
}

RankOrder rank_order(const std::vector<OrderedGroup>& groups, std::size_t shuffles,
                     std::uint64_t seed) {
  require(!groups.empty(), "an order needs groups");
  RankOrder order;
  order.correlation = mean_order(groups);
  std::vector<OrderedGroup> shuffled = groups;
  Random random(seed, Stream::kGroupings);
  double sum = 0.0;
  std::size_t as_high = 1;
  for (std::size_t i = 0; i < shuffles; ++i) {
    for (OrderedGroup& group : shuffled) shuffle(group.numbers, random);
    const double correlation = mean_order(shuffled);
    sum += correlation;
    as_high += correlation >= order.correlation - kRankRounding ? 1 : 0;
  }
  if (shuffles > 0) order.shuffled = sum / static_cast<double>(shuffles);
  order.shuffled_share = static_cast<double>(as_high) / static_cast<double>(shuffles + 1);
  return order;
}

}  // namespace somato
