#include "studies/inference/local_regression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// The gradient of the weighted sum of squares is 0 at the minimum.
TEST(LocalRegression, MinimizesTheWeightedSumOfSquares) {
  Random random(3);
  constexpr std::size_t kRows = 40;
  constexpr std::size_t kColumns = 3;
  Matrix<double> predictors(kRows, kColumns);
  std::vector<double> weights;
  std::vector<double> values;
  for (std::size_t i = 0; i < kRows; ++i) {
    for (double& value : predictors.row(i)) value = random.normal() + 3.0;
    weights.push_back(random.uniform());
    values.push_back(2.0 * predictors(i, 0) - predictors(i, 2) + random.normal());
  }
  const LocalRegression regression(predictors, weights);
  const std::vector<double> found = regression.coefficients(values);
  std::vector<double> rest = values;
  regression.adjust(rest);  // the intercept and the residuals
  double mean = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < kRows; ++i) {
    mean += weights[i] * rest[i];
    all += weights[i];
  }
  mean /= all;
  for (std::size_t column = 0; column < kColumns; ++column) {
    double gradient = 0.0;
    for (std::size_t i = 0; i < kRows; ++i)
      gradient += weights[i] * predictors(i, column) * (rest[i] - mean);
    EXPECT_NEAR(gradient, 0.0, 1e-9) << column;
  }
  EXPECT_NEAR(found[0], 2.0, 0.6);
  EXPECT_NEAR(found[2], -1.0, 0.6);
}

TEST(LocalRegression, IsExactForALine) {
  const LocalRegression regression(Matrix<double>(3, 1, {0.0, 1.0, 4.0}),
                                   std::vector<double>{1.0, 0.5, 0.25});
  std::vector<double> values{7.0, 10.0, 19.0};
  EXPECT_NEAR(regression.coefficients(values)[0], 3.0, 1e-12);
  regression.adjust(values);
  for (const double value : values) EXPECT_NEAR(value, 7.0, 1e-12);
}

TEST(LocalRegression, ConstantAndDependentPredictorsHaveNoPart) {
  const Matrix<double> predictors(4, 3, {2, 1, 3, 2, 2, 6, 2, 3, 9, 2, 5, 15});  // constant, x, 3 x
  const LocalRegression regression(predictors, std::vector<double>(4, 0.25));
  const std::vector<double> found = regression.coefficients(std::vector<double>{1, 2, 3, 5});
  EXPECT_EQ(found[0], 0.0);
  EXPECT_NEAR(found[1], 1.0, 1e-12);
  EXPECT_EQ(found[2], 0.0);
  const LocalRegression of_one(Matrix<double>(1, 1, std::vector<double>{5.0}),
                               std::vector<double>{1.0});
  EXPECT_EQ(of_one.coefficients(std::vector<double>{3.0}), (std::vector<double>{0.0}));
  EXPECT_THROW((void)of_one.coefficients(std::vector<double>{}), InvalidArgument);
}

}  // namespace
}  // namespace somato
