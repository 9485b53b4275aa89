#include "studies/inference/ridge_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Matrix<double> normal_numbers(std::size_t rows, std::size_t columns, std::uint64_t seed) {
  Random random(seed);
  Matrix<double> made(rows, columns);
  for (double& value : made.values()) value = 2.0 * random.normal() + 5.0;
  return made;
}

// Gauss and Jordan, with pivots.
std::vector<double> plainly_solved(Matrix<double> a, std::vector<double> b) {
  for (std::size_t c = 0; c < b.size(); ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < b.size(); ++r) {
      if (std::abs(a(r, c)) > std::abs(a(pivot, c))) pivot = r;
    }
    for (std::size_t k = 0; k < b.size(); ++k) std::swap(a(c, k), a(pivot, k));
    std::swap(b[c], b[pivot]);
    for (std::size_t r = 0; r < b.size(); ++r) {
      if (r == c) continue;
      const double factor = a(r, c) / a(c, c);
      for (std::size_t k = 0; k < b.size(); ++k) a(r, k) -= factor * a(c, k);
      b[r] -= factor * b[c];
    }
  }
  for (std::size_t c = 0; c < b.size(); ++c) b[c] /= a(c, c);
  return b;
}

// The scales of all rows are used, as the predictions do, but only `rows` are fitted: the normal
// equations with an intercept that is not penalized.
double plain_prediction(const Matrix<double>& x, const Matrix<double>& y,
                        const std::vector<std::size_t>& rows, double penalty,
                        const std::vector<double>& given) {
  const std::size_t p = x.columns();
  std::vector<double> mean(p, 0.0);
  std::vector<double> deviation(p, 0.0);
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t i = 0; i < x.rows(); ++i) mean[c] += x(i, c) / static_cast<double>(x.rows());
    for (std::size_t i = 0; i < x.rows(); ++i)
      deviation[c] += (x(i, c) - mean[c]) * (x(i, c) - mean[c]) / static_cast<double>(x.rows());
    deviation[c] = std::sqrt(deviation[c]);
  }
  const auto row_of = [&](const std::vector<double>& values) {
    std::vector<double> row{1.0};
    for (std::size_t c = 0; c < p; ++c) row.push_back((values[c] - mean[c]) / deviation[c]);
    return row;
  };
  Matrix<double> left(p + 1, p + 1);
  std::vector<double> right(p + 1, 0.0);
  for (const std::size_t i : rows) {
    const std::vector<double> row = row_of({x.row(i).begin(), x.row(i).end()});
    for (std::size_t a = 0; a <= p; ++a) {
      right[a] += row[a] * y(i, 0);
      for (std::size_t b = 0; b <= p; ++b) left(a, b) += row[a] * row[b];
    }
  }
  for (std::size_t c = 1; c <= p; ++c) left(c, c) += penalty * static_cast<double>(x.rows());
  const std::vector<double> weights = plainly_solved(left, right);
  const std::vector<double> row = row_of(given);
  double predicted = 0.0;
  for (std::size_t c = 0; c <= p; ++c) predicted += weights[c] * row[c];
  return predicted;
}

TEST(RidgePredictions, AreThoseOfRegressionsWithoutEachRow) {
  for (const std::size_t columns : {std::size_t{4}, std::size_t{30}}) {  // more than rows, too
    const Matrix<double> x = normal_numbers(12, columns, 1);
    Matrix<double> y = normal_numbers(12, 1, 2);
    for (std::size_t i = 0; i < 12; ++i) y(i, 0) += 3.0 * x(i, 1);
    const std::vector<double> given(columns, 4.0);
    const RidgePrediction found = ridge_predictions(x, y, given)[0];
    std::vector<std::size_t> all;
    double squares = 0.0;
    for (std::size_t i = 0; i < 12; ++i) {
      all.push_back(i);
      std::vector<std::size_t> others;
      for (std::size_t k = 0; k < 12; ++k) {
        if (k != i) others.push_back(k);
      }
      const double expected =
          plain_prediction(x, y, others, found.penalty, {x.row(i).begin(), x.row(i).end()});
      EXPECT_NEAR(found.of_rows[i], expected, 1e-6);
      squares += (expected - y(i, 0)) * (expected - y(i, 0));
    }
    EXPECT_NEAR(found.of_given, plain_prediction(x, y, all, found.penalty, given), 1e-6);
    EXPECT_NEAR(found.error, std::sqrt(squares / 12.0), 1e-6);
    for (const double penalty : kRidgePenalties) {
      double error = 0.0;
      for (std::size_t i = 0; i < 12; ++i) {
        std::vector<std::size_t> others = all;
        std::erase(others, i);
        const double difference =
            plain_prediction(x, y, others, penalty, {x.row(i).begin(), x.row(i).end()}) - y(i, 0);
        error += difference * difference;
      }
      EXPECT_GE(std::sqrt(error / 12.0), found.error - 1e-9) << penalty;
    }
  }
}

TEST(RidgePredictions, AreThoseOfRegressionsWithoutTheGroup) {
  const Matrix<double> x = normal_numbers(12, 20, 1);
  Matrix<double> y = normal_numbers(12, 1, 2);
  for (std::size_t i = 0; i < 12; ++i) y(i, 0) += 3.0 * x(i, 1);
  const std::vector<std::size_t> groups{4, 4, 9, 9, 9, 0, 0, 0, 0, 4, 4, 9};
  const RidgePrediction found = ridge_predictions(x, y, std::vector(20, 4.0), groups)[0];
  for (std::size_t i = 0; i < 12; ++i) {
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < 12; ++k) {
      if (groups[k] != groups[i]) others.push_back(k);
    }
    const double expected =
        plain_prediction(x, y, others, found.penalty, {x.row(i).begin(), x.row(i).end()});
    EXPECT_NEAR(found.of_rows[i], expected, 1e-6);
  }
  const std::vector<std::size_t> one_group(12, 3);
  EXPECT_THROW(ridge_predictions(x, y, std::vector(20, 4.0), one_group), InvalidArgument);
}

TEST(RidgePredictions, AreMeansOfTheOthersWithoutInformation) {
  const Matrix<double> constant(5, 2, 3.0);
  Matrix<double> y(5, 1);
  for (std::size_t i = 0; i < 5; ++i) y(i, 0) = static_cast<double>(i);
  const RidgePrediction found = ridge_predictions(constant, y, std::vector{3.0, 3.0})[0];
  EXPECT_NEAR(found.of_given, 2.0, 1e-12);
  EXPECT_NEAR(found.of_rows[4], 1.5, 1e-12);
  EXPECT_EQ(found.penalty, 100.0) << "of equal ones the greatest";
}

TEST(RidgePredictions, BearPredictorsThatFollowFromOthers) {
  Matrix<double> x = normal_numbers(20, 3, 5);
  Matrix<double> y(20, 1);
  for (std::size_t i = 0; i < 20; ++i) {
    x(i, 1) = 1e9 * x(i, 0);
    x(i, 2) = 1e-9 * x(i, 0);
    y(i, 0) = x(i, 0);
  }
  const RidgePrediction found = ridge_predictions(x, y, x.row(3))[0];
  EXPECT_NEAR(found.of_given, y(3, 0), 0.01);
  EXPECT_LT(found.error, 0.01);
}

TEST(RidgePredictions, RefuseSizesThatDoNotAgree) {
  const std::vector<double> given{1.0, 2.0};
  EXPECT_THROW(ridge_predictions(normal_numbers(4, 2, 1), normal_numbers(3, 1, 1), given),
               InvalidArgument);
  EXPECT_THROW(ridge_predictions(normal_numbers(4, 3, 1), normal_numbers(4, 1, 1), given),
               InvalidArgument);
  EXPECT_THROW(ridge_predictions(normal_numbers(2, 2, 1), normal_numbers(2, 1, 1), given),
               InvalidArgument);
}

}  // namespace
}  // namespace somato
