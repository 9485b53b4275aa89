#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// A prediction of one number from many.
struct RidgePrediction {
  std::vector<double> of_rows;  ///< For each row, by the regression on rows of other groups.
  double of_given = 0.0;        ///< For the given predictors, by the regression on all rows.
  double error = 0.0;    ///< Root mean square of the differences of `of_rows` from the values.
  double penalty = 0.0;  ///< The selected one, as a share of the number of rows.
};

/// The penalties that are tried, as shares of the number of rows.
inline constexpr double kRidgePenalties[] = {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0};

/// Predicts columns of `values` from `predictors` by ridge regressions with an intercept, of which
/// the penalty is the one of kRidgePenalties with the least error on rows that were left out, in
/// closed form; of equal ones the greatest. Predictors are scaled to mean 0 and standard deviation
/// 1; constant ones have no effect. Rows with the same number in `groups` are left out together;
/// without groups, each row is left out by itself. One prediction for each column of values. Throws
/// InvalidArgument for sizes that do not agree, fewer than three rows or a single group.
///
/// Sources: A. E. Hoerl, R. W. Kennard, Technometrics 12 (1970); the error of left-out rows: D. M.
/// Allen, Technometrics 16 (1974).
std::vector<RidgePrediction> ridge_predictions(const Matrix<double>& predictors,
                                               const Matrix<double>& values,
                                               std::span<const double> given,
                                               std::span<const std::size_t> groups = {});

}  // namespace somato
