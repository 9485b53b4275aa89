#include "studies/inference/ridge_regression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Columns with mean 0 and standard deviation 1, without constant ones; the given row likewise.
struct StandardPredictors {
  Matrix<double> rows;
  std::vector<double> given;
};

struct ColumnScale {
  std::size_t column = 0;
  double mean = 0.0;
  double deviation = 0.0;
};

std::vector<ColumnScale> varying_columns(const Matrix<double>& rows) {
  std::vector<ColumnScale> scales;
  const auto count = static_cast<double>(rows.rows());
  for (std::size_t c = 0; c < rows.columns(); ++c) {
    double mean = 0.0;
    double greatest = 0.0;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      mean += rows(i, c) / count;
      greatest = std::max(greatest, std::abs(rows(i, c)));
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < rows.rows(); ++i)
      squares += (rows(i, c) - mean) * (rows(i, c) - mean);
    const double deviation = std::sqrt(squares / count);
    if (deviation > 1e-12 * greatest) scales.push_back({c, mean, deviation});  // above rounding
  }
  return scales;
}

StandardPredictors standardized(const Matrix<double>& rows, std::span<const double> given) {
  const std::vector<ColumnScale> scales = varying_columns(rows);
  StandardPredictors standard{Matrix<double>(rows.rows(), scales.size()), {}};
  for (std::size_t c = 0; c < scales.size(); ++c) {
    const auto& [column, mean, deviation] = scales[c];
    for (std::size_t i = 0; i < rows.rows(); ++i)
      standard.rows(i, c) = (rows(i, column) - mean) / deviation;
    standard.given.push_back((given[column] - mean) / deviation);
  }
  return standard;
}

// The sums of products of the columns; the lower triangle.
Matrix<double> products_of(const Matrix<double>& rows) {
  Matrix<double> products(rows.columns(), rows.columns());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto row = rows.row(i);
    for (std::size_t a = 0; a < row.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) products(a, b) += row[a] * row[b];
    }
  }
  return products;
}

// The triangle of Cholesky of the products with a penalty on the diagonal. `least` is a lower bound
// of the squares of its diagonal, which rounding may make negative.
Matrix<double> triangle_of(const Matrix<double>& products, double penalty, double least) {
  Matrix<double> triangle = products;
  for (std::size_t a = 0; a < triangle.rows(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto before = dot(triangle.row(a).first(b), triangle.row(b).first(b));
      if (b < a) {
        triangle(a, b) = (triangle(a, b) - before) / triangle(b, b);
      } else {
        triangle(a, a) = std::sqrt(std::max(triangle(a, a) + penalty - before, least));
      }
    }
  }
  return triangle;
}

// Solves the triangle: the product of two solutions is their product by the inverse.
std::vector<double> solved(const Matrix<double>& triangle, std::span<const double> right) {
  std::vector<double> solution(right.begin(), right.end());
  for (std::size_t a = 0; a < solution.size(); ++a) {
    const double before = dot(triangle.row(a).first(a), std::span(solution).first(a));
    solution[a] = (solution[a] - before) / triangle(a, a);
  }
  return solution;
}

// Solves the triangle and then its transpose: the inverse of the products.
std::vector<double> solved_twice(const Matrix<double>& triangle, std::span<const double> right) {
  std::vector<double> solution = solved(triangle, right);
  for (std::size_t a = solution.size(); a-- > 0;) {
    for (std::size_t later = a + 1; later < solution.size(); ++later)
      solution[a] -= triangle(later, a) * solution[later];
    solution[a] /= triangle(a, a);
  }
  return solution;
}

// Rows that are left out together.
using Groups = std::vector<std::vector<std::size_t>>;

Groups groups_of(std::span<const std::size_t> numbers, std::size_t rows) {
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < rows; ++i) groups[numbers.empty() ? i : numbers[i]].push_back(i);
  Groups all;
  for (auto& [number, members] : groups) all.push_back(std::move(members));
  return all;
}

// The values less their mean, times the predictors.
std::vector<double> sums_with(const Matrix<double>& rows, std::span<const double> centred) {
  std::vector<double> sums(rows.columns(), 0.0);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += centred[i] * rows(i, c);
  }
  return sums;
}

// The regressions with one penalty.
class Ridge {
 public:
  Ridge(const StandardPredictors& predictors, const Matrix<double>& products, const Groups& groups,
        double penalty)
      : predictors_(predictors),
        groups_(groups),
        triangle_(triangle_of(products, penalty * static_cast<double>(predictors.rows.rows()),
                              penalty * static_cast<double>(predictors.rows.rows()))),
        given_(solved(triangle_, predictors.given)),
        penalty_(penalty) {
    for (std::size_t i = 0; i < predictors.rows.rows(); ++i)
      rows_.push_back(solved(triangle_, predictors.rows.row(i)));
    for (const auto& members : groups) rests_.push_back(triangle_of(rest_of(members), 0.0, 1e-9));
  }

  RidgePrediction prediction(const std::vector<double>& values) const {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    std::vector<double> centred = values;
    for (double& value : centred) value -= mean;
    const std::vector<double> sums = solved(triangle_, sums_with(predictors_.rows, centred));
    RidgePrediction found{{}, mean + dot(given_, sums), 0.0, penalty_};
    double squares = 0.0;
    found.of_rows = values;
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      std::vector<double> differences;
      for (const std::size_t i : groups_[group])
        differences.push_back(centred[i] - dot(rows_[i], sums));
      differences = solved_twice(rests_[group], differences);
      for (std::size_t k = 0; k < differences.size(); ++k) {
        found.of_rows[groups_[group][k]] -= differences[k];
        squares += differences[k] * differences[k];
      }
    }
    found.error = std::sqrt(squares / count);
    return found;
  }

 private:
  // The identity less the shares of the rows of a group in their own predictions: differences from
  // predictions are this matrix times those from the predictions without the group.
  Matrix<double> rest_of(const std::vector<std::size_t>& members) const {
    Matrix<double> rest(members.size(), members.size());
    for (std::size_t a = 0; a < members.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const double share =
            1.0 / static_cast<double>(rows_.size()) + dot(rows_[members[a]], rows_[members[b]]);
        rest(a, b) = (a == b ? 1.0 : 0.0) - share;
      }
    }
    return rest;
  }

  const StandardPredictors& predictors_;
  const Groups& groups_;
  Matrix<double> triangle_;
  std::vector<double> given_;
  std::vector<std::vector<double>> rows_;
  std::vector<Matrix<double>> rests_;  // triangles, one for each group
  double penalty_;
};

std::vector<double> column_of(const Matrix<double>& values, std::size_t column) {
  std::vector<double> all;
  all.reserve(values.rows());
  for (std::size_t i = 0; i < values.rows(); ++i) all.push_back(values(i, column));
  return all;
}

}  // namespace

std::vector<RidgePrediction> ridge_predictions(const Matrix<double>& predictors,
                                               const Matrix<double>& values,
                                               std::span<const double> given,
                                               std::span<const std::size_t> numbers) {
  require(predictors.rows() == values.rows() && given.size() == predictors.columns(),
          "each row has predictors and values");
  require(values.rows() >= 3, "a regression requires three rows");
  require(numbers.empty() || numbers.size() == values.rows(), "each row has a group");
  const Groups groups = groups_of(numbers, values.rows());
  require(groups.size() >= 2, "a group is predicted from others");
  const StandardPredictors standard = standardized(predictors, given);
  const Matrix<double> products = products_of(standard.rows);
  std::vector<RidgePrediction> best(values.columns());
  for (RidgePrediction& one : best) one.error = std::numeric_limits<double>::infinity();
  for (const double penalty : kRidgePenalties) {
    const Ridge ridge(standard, products, groups, penalty);
    for (std::size_t v = 0; v < best.size(); ++v) {
      RidgePrediction found = ridge.prediction(column_of(values, v));
      if (found.error <= best[v].error) best[v] = std::move(found);
    }
  }
  return best;
}

}  // namespace somato
