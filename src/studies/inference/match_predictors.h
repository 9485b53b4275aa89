#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "somato/core/matrix.h"
#include "studies/inference/ridge_regression.h"

namespace somato {

/// Statistics of draws and the observed ones, as numbers from which places are predicted.
struct MatchPredictors {
  Matrix<double> of_draws;       ///< One row for each draw.
  std::vector<double> observed;  ///< One for each column.
};

/// Replaces each statistic by its place among those of the draws: the share of the draws with
/// smaller values and half of those with equal ones. Places of observed values are interpolated
/// linearly, and do not leave those of the draws. Units and scales have no effect. All values are
/// finite; at least one row.
MatchPredictors places_among_draws(const Matrix<double>& statistics,
                                   std::span<const double> observed);

/// For each column of predictors, the share of its variance that a regression on the places of the
/// unknowns predicts in rows of left-out groups (see ridge_predictions()): at most 1, below 0 if
/// it predicts worse than the mean; 0 for a constant column.
std::vector<double> explained_shares(const Matrix<double>& predictors, const Matrix<double>& places,
                                     std::span<const std::size_t> groups);

/// Statistics of which the unknowns explain a smaller share have no part in predictions: movements
/// or noise cause the differences between their values.
inline constexpr double kLeastExplained = 0.1;

/// Predicts the place of each unknown from the predictors. An unknown that is predicted no better
/// than by the mean of its places has this mean as its prediction everywhere.
std::vector<RidgePrediction> predicted_places(const MatchPredictors& predictors,
                                              const Matrix<double>& places,
                                              std::span<const std::size_t> groups);

/// Whether the observed prediction lies beyond those of all draws by more than its error.
bool is_outside(const RidgePrediction& prediction);

}  // namespace somato
