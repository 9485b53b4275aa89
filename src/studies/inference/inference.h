#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/inference/acceptance.h"
#include "studies/inference/calibration.h"
#include "studies/inference/posterior_summary.h"
#include "studies/inference/targets.h"
#include "studies/sweep/sweep_results.h"

namespace somato {

/// An unknown before and after the observations.
struct InferredUnknown {
  PlaceSummary prior;
  PlaceSummary posterior;
  std::vector<double> prior_shares;      ///< One for each of sweep_cells().
  std::vector<double> posterior_shares;  ///< The same, weighted.

  /// The standard deviation of the posterior's places, as a share of that of the prior's; 1 if the
  /// observations say nothing.
  double shrinkage() const;
};

/// The unknowns that the draws of a sweep and the observations give.
struct Inference {
  Simulations simulations;
  Posterior posterior;
  std::vector<InferredUnknown> unknowns;
  Matrix<double> correlations;  ///< Those of the unknowns' places in the posterior.
  Calibration calibration;
  std::vector<double> predicted;  ///< For each target: the mean of the accepted simulations.
};

/// The simulations of the completed points: one for each pair of each point. A measure that cannot
/// be taken is NaN.
Simulations simulations_of(const SweepResults& results);

/// Infers the unknowns of a sweep whose measures are those of `targets`. Errors: kData if no
/// simulation has all measures, with a measure that none has.
Result<Inference> infer(const SweepResults& results, const Targets& targets);

/// The places of a point, whose unknowns all have values, in the priors of the unknowns: 0 to 1.
std::vector<double> places_in_prior(const SweepDescription& sweep, const SweepPoint& point);

/// For each unknown, whether places between those drawn have a meaning.
std::vector<bool> continuous_unknowns(const SweepDescription& sweep);

/// Summarizes a posterior of simulations and checks the rule that gave it. Sizes must agree.
Inference summarized(const SweepDescription& sweep, Simulations simulations, Posterior posterior,
                     const std::vector<double>& scales, const AcceptanceRule& rule,
                     const InferenceParameters& parameters);

/// The value of unknown number `unknown` at a place of its prior.
Value value_at_place(const SweepDescription& sweep, std::size_t unknown, double place);

/// Settings of the posterior: `bodies` points, from accepted simulations that are selected with
/// probabilities in proportion to their weights (systematically, with a random begin).
std::vector<SweepPoint> posterior_points(const SweepDescription& sweep, const Posterior& posterior,
                                         std::size_t bodies, std::uint64_t seed);

}  // namespace somato
