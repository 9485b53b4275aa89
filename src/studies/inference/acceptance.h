#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Draws from a prior, and what was simulated with them. A simulation is one map with its
/// recording, as a paper shows it; several simulations may share a draw.
struct Simulations {
  /// One row for each simulation: the place of each unknown in its prior, from 0 to 1, evenly
  /// distributed.
  Matrix<double> places;
  /// One row for each simulation: the value of each target; NaN where a value could not be
  /// measured.
  Matrix<double> statistics;
  std::vector<std::size_t> draw;  ///< Number of the draw of each simulation.
  std::vector<bool>
      is_continuous;  ///< For each unknown: whether places between those drawn have a meaning.
  /// For each simulation, the number of what several draws share, such as movements whose sensors
  /// they play; empty: draws share nothing.
  std::vector<std::size_t> group;

  /// The group of simulation `i`, or its draw.
  std::size_t group_of(std::size_t i) const { return group.empty() ? draw[i] : group[i]; }
};

/// Observed values, and the difference of each that counts as 1.
struct Observation {
  std::vector<double> values;
  std::vector<double> scales;  ///< Above 0.
};

/// The rule by which simulations are accepted.
struct AcceptanceRule {
  double share = 0.05;   ///< Share of the simulations, above 0 and at most 1.
  bool adjusted = true;  ///< Whether places are adjusted.
  /// Whether the statistics are predictions of the places, one for each unknown: places are then
  /// adjusted by what their predictions differ from the observed ones, instead of by local
  /// regression.
  bool predictions = false;
};

/// A sample of the posterior distribution.
struct Posterior {
  std::vector<std::size_t> simulations;  ///< Numbers of the accepted ones, ascending.
  std::vector<double> weights;           ///< One for each, with the sum 1.
  Matrix<double> places;  ///< One row for each, adjusted if the rule requires it; from 0 to 1.

  bool is_adjusted = false;  ///< Whether places have been adjusted.

  std::size_t size() const { return simulations.size(); }
};

/// Column `unknown` of places: its place in each simulation.
std::vector<double> places_of(const Matrix<double>& places, std::size_t unknown);

/// Accepted simulations that a regression requires for the intercept and each statistic: a usual
/// least number.
inline constexpr std::size_t kLeastOfCoefficient = 5;

/// The distance of simulated from observed values: the root of the mean square of their
/// differences, each divided by its scale. Infinite if a value is not finite.
double distance_of(std::span<const double> statistics, const Observation& observed);

/// Accepts the share of the simulations that are nearest to the observation, at least one, and all
/// others at the same distance as the last one. Weights fall with the square of the distance
/// (Epanechnikov) and reach 0 at the nearest simulation that is not accepted. Adjusted places are
/// those of continuous unknowns, on the scale of their logarithmic odds, less what a weighted
/// linear regression on the statistics predicts for the difference from the observation; statistics
/// that are constant or follow from others have no part in it. With `predictions`, adjusted places
/// are those less the prediction, plus the observed prediction, within the prior.
///
/// `left_out` is a group (or a draw, without groups) whose simulations are not accepted. Nothing if
/// no simulation has finite statistics. Throws InvalidArgument for sizes that do not agree, scales
/// or shares out of range.
///
/// Source: M. A. Beaumont, W. Zhang, D. J. Balding, "Approximate Bayesian computation in population
/// genetics", Genetics 162 (2002); the logarithmic odds keep adjusted places in their range.
std::optional<Posterior> accept_nearest(const Simulations& simulations, const Observation& observed,
                                        const AcceptanceRule& rule,
                                        std::optional<std::size_t> left_out = {});

}  // namespace somato
