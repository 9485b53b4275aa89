#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "studies/inference/inference.h"
#include "studies/inference/recording_statistics.h"
#include "studies/inference/ridge_regression.h"
#include "studies/sweep/sweep_plan.h"

namespace somato {

/// The recording that a simulated body is fitted to, in halves.
struct MatchedTouch {
  ComparedTouch compared;
  std::vector<Statistic> names;
  std::vector<double> fitted;    ///< The statistics of the half to which settings are fitted.
  std::vector<double> held_out;  ///< Those of the other half, which only distances use.
  std::vector<double> scales;    ///< Those of the first half; see statistic_scales().
  std::size_t fitted_explorations = 0;
  std::size_t held_out_explorations = 0;
};

/// The statistics of `real`, of what it has in common with `simulated`, a recording of the body.
/// Errors: those of compared_touch() and touch_features(); kData if a half has fewer than two
/// explorations.
Result<MatchedTouch> matched_touch(const Recording& real, const Recording& simulated,
                                   const MatchParameters& parameters);

/// The statistics of a simulated recording. Errors: those of touch_features().
Result<std::vector<double>> simulated_statistics(const MatchedTouch& touch,
                                                 const Recording& simulated);

/// How far statistics are from others, in units of their scales.
struct TouchDistance {
  double median = 0.0;            ///< Median of the absolute differences.
  double root_mean_square = 0.0;  ///< Root of the mean square.
  double within_two = 0.0;        ///< Share of the statistics that differ by less than 2.
};

/// Draws from a prior, each with the statistics of one recording.
struct MatchDraws {
  SystemSweep sweep;
  std::vector<SweepPoint> points;
  Matrix<double> statistics;  ///< One row for each point.
  /// For each point, the number of the movements whose sensors it plays; empty: each point has its
  /// own movements.
  std::vector<std::size_t> movements;
};

/// Settings of a body that agree with a recording.
struct Match {
  MatchedTouch touch;
  MatchDraws draws;
  InferenceParameters parameters;
  std::vector<std::string> left_out;  ///< For each statistic: why it is not used, or nothing.
  std::vector<bool> out_of_reach;     ///< Whether no draw is at the observed value or beyond it.
  /// For each statistic: the share of its variance that the unknowns explain, see
  /// explained_shares(); NaN if it is not used.
  std::vector<double> explained;
  std::vector<std::string> outside;  ///< Unknowns whose prediction is_outside() of the draws'.
  std::string not_adjusted;  ///< Why settings are not adjusted as the rule requires; or empty.
  std::vector<RidgePrediction>
      summaries;                        ///< One for each unknown: the statistic of its inference.
  Inference inference;                  ///< The inference from draws with all used statistics.
  std::vector<TouchDistance> of_draws;  ///< From the held-out half, of these draws.
  TouchDistance by_chance;              ///< The distance of the fitted half from the held-out one.
  Matrix<double> system;  ///< Statistics of the unchanged body with fresh seeds, in rows.
  Matrix<double> fresh;   ///< The same of settings of the posterior, `pairs` rows for each.
  std::vector<SweepPoint> bodies;  ///< These settings.
};

/// Infers the unknowns from the statistics of the fitted half. Statistics enter as places among
/// those of the draws (places_among_draws()). Those that the unknowns change (kLeastExplained)
/// predict each unknown by a ridge regression, of which draws with the same movements are left out
/// together. The predictions, of each draw by draws with other movements, are the statistics of the
/// acceptance; their errors are its scales. Accepted settings are adjusted by the differences of
/// their predictions from the observed ones, unless a prediction is outside of those of the draws,
/// or settings of draws that are held out become less accurate by it.
///
/// Statistics that no draw reaches have no part, unless no other remains (the nearest value of a
/// draw then counts as observed), and predictions are kept within those of the draws. Statistics
/// without a scale and those that a tenth of the draws lacks have no part; draws that lack others
/// neither.
///
/// Errors (kData): no statistic that can be used, fewer than three draws. Source: P. Fearnhead, D.
/// Prangle, "Constructing summary statistics for approximate Bayesian computation", J. R. Stat.
/// Soc. B 74 (2012).
Result<Match> match_touch(MatchedTouch touch, MatchDraws draws,
                          const InferenceParameters& parameters);

/// The distance of statistics from the held-out half, over the used ones that both have.
TouchDistance distance_from_held_out(const Match& match, std::span<const double> statistics);

/// The mean distance of recordings from the held-out half; one row of statistics for each.
TouchDistance mean_distance(const Match& match, const Matrix<double>& statistics);

}  // namespace somato
