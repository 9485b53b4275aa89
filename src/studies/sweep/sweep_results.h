#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/studies/claim.h"
#include "somato/studies/reproduction.h"
#include "studies/sweep/first_order.h"
#include "studies/sweep/sweep_plan.h"

namespace somato {

/// The results of a point.
struct SweepPointResults {
  SweepPoint point;
  std::vector<std::string> recordings;              ///< Names of those it was run on, once each.
  std::vector<std::optional<ClaimOutcome>> claims;  ///< Nothing where it cannot be judged.
  std::vector<std::optional<ClaimOutcome>> measured = {};  ///< The same for SystemSweep::measured.

  /// The number of pairs that it was run on: the most values of a claim or measure.
  std::size_t pairs() const;
};

/// Judges the claims of a sweep by what its parts found at a point.
SweepPointResults judge_point(const SystemSweep& sweep, const SweepPoint& point,
                              const std::vector<PartResults>& parts);

/// Everything that a sweep found.
struct SweepResults {
  SystemSweep sweep;
  std::vector<SweepPointResults> points;
};

/// The points that lie in a cell of an unknown.
struct CellOutcome {
  std::size_t points = 0;
  double share = 0.0;  ///< Mean share of the pairs in which the claim holds; 0 without points.
};

/// The effect of an unknown on a claim.
struct UnknownEffect {
  std::vector<CellOutcome> cells;   ///< One for each of sweep_cells().
  double change = 0.0;              ///< From the least mean share of a cell to the greatest.
  std::optional<FirstOrder> order;  ///< If all unknowns vary at once and the shares differ.
};

/// The outcome of a claim over the points at which it can be evaluated.
struct ClaimEffects {
  std::size_t points = 0;
  double holds = 0.0;                  ///< Share of the points where it holds.
  double mean_share = 0.0;             ///< Mean over the points of the share of the pairs.
  std::optional<double> system_share;  ///< For the unchanged system; of one_at_a_time.
  std::vector<UnknownEffect> effects;  ///< One for each unknown.

  /// Numbers of the unknowns, from the one that does most.
  std::vector<std::size_t> by_effect() const;
};

/// The outcome of claim number `claim`.
ClaimEffects effects_on(const SweepResults& results, std::size_t claim);

/// The results as sweep.json, version 1; the same bytes for the same results.
std::string to_json(const SweepResults& results);

}  // namespace somato
