#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// A weighted linear regression, with an intercept, on given rows of predictors. It subtracts from
/// values what the regression predicts beyond its prediction where all predictors are 0.
class LocalRegression {
 public:
  /// One row of predictors for each value, and a weight of each, at least 0. Predictors that are
  /// constant, or follow from those before them up to rounding, have the coefficient 0.
  LocalRegression(Matrix<double> predictors, std::span<const double> weights);

  /// The coefficients of the predictors for these values.
  std::vector<double> coefficients(std::span<const double> values) const;

  /// Subtracts from each value the product of the coefficients and its predictors.
  void adjust(std::span<double> values) const;

 private:
  /// A predictor without what the ones before it explain, scaled to length 1; empty if nothing is
  /// left.
  std::vector<double> direction_of(std::size_t column);

  Matrix<double> predictors_;
  std::vector<double> roots_;  ///< Square roots of the weights.
  std::vector<std::vector<double>>
      directions_;           ///< Those of the intercept, then of each predictor.
  Matrix<double> triangle_;  ///< (i, j): the part of column j along direction i.
};

}  // namespace somato
