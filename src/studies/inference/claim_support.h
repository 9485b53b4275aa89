#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "studies/inference/acceptance.h"
#include "studies/inference/targets.h"
#include "studies/sweep/sweep_results.h"

namespace somato {

/// Whether settings explain a claim.
enum class ClaimSupport {
  /// It holds in at least kExplainedFrom of the fresh pairs of the posterior, at least kLeastPairs,
  /// and in fewer of their wrong groupings.
  kExplained,
  /// It holds in at least kExcludedBelow of all simulations, or of the fresh pairs.
  kReachable,
  kExcluded,    ///< It holds in fewer, of at least kDecidingDraws draws.
  kNotDecided,  ///< It holds in fewer, of fewer draws; or it could not be judged.
};

template <>
struct Choices<ClaimSupport> {
  static const std::vector<std::pair<ClaimSupport, std::string>>& all();
};

inline constexpr double kExplainedFrom = 0.9;
inline constexpr double kExcludedBelow = 0.01;
inline constexpr std::size_t kDecidingDraws = 1000;

/// Whether each simulation meets a claim: 1, 0, or NaN if it cannot be judged.
using MetClaims = std::vector<double>;

/// Those of claim number `claim`, in the order of simulations_of().
MetClaims met_by_simulations(const SweepResults& results, std::size_t claim);

/// The values of the first measure of a claim, over all simulations in which it could be judged.
struct ClaimValues {
  double least = 0.0;
  double median = 0.0;  ///< The lower one of an even number, so that it is a value of a map.
  double greatest = 0.0;
};

/// The shares of maps that meet a claim.
struct ClaimShares {
  std::optional<double> prior;        ///< Share of all simulations.
  std::optional<ClaimValues> values;  ///< Those of all simulations.
  std::optional<double>
      posterior;  ///< Weighted share of the accepted ones: on the seeds that selected them.
  /// The same where the targets with the measure of the claim had no part in the selection.
  std::optional<double> left_out;
  std::size_t fresh_pairs = 0;  ///< Number of the fresh pairs in which it could be judged.
  std::optional<ClaimVerdict> fresh_verdict;  ///< On all fresh pairs, by the first measure.
  /// The same by the second measure of the claim, if it has one.
  std::optional<ClaimVerdict> fresh_verdict_as_written;
  std::optional<double> fresh;   ///< Share with fresh seeds, at settings of the posterior.
  std::optional<double> chance;  ///< Mean share of wrong groupings that meet it, of all draws.
  std::optional<double> fresh_chance;  ///< The same, of the fresh pairs.
  std::size_t draws = 0;               ///< Number of draws at which it could be judged.

  ClaimSupport support() const;
};

/// The shares of claim number `claim` of a sweep. `fresh` are the results at settings of the
/// posterior, with fresh seeds; without points if they have not been run.
ClaimShares shares_of(const SweepResults& results, std::size_t claim,
                      const Simulations& simulations, const Posterior& posterior,
                      const Targets& targets, const SweepResults& fresh);

/// Two claims that are met together less often than by their own shares.
struct ClaimConflict {
  std::size_t first = 0;
  std::size_t second = 0;
  double together = 0.0;    ///< Number of the simulations that meet both.
  double expected = 0.0;    ///< The number if they were independent.
  double deviations = 0.0;  ///< The difference in standard deviations of that number, below 0.
};

/// The outcome of claim number `claim` on the pairs of all points together. Its range by chance is
/// the narrowest one of a point. Nothing if no point could be judged.
std::optional<ClaimOutcome> pooled_outcome(const SweepResults& results, std::size_t claim);

/// The pairs of claims with at least `least_expected` expected simulations and a difference of more
/// than three standard deviations, the greatest difference first. Pairs of one draw are not
/// independent: the variance is that of as many independent simulations as there are draws, which
/// `simulations_of_draw`, the mean number of simulations of a draw, gives.
std::vector<ClaimConflict> conflicts_of(const std::vector<MetClaims>& met,
                                        double simulations_of_draw, double least_expected);

/// For each point of a sweep: the sum of the shares of pairs in which the claims hold, which is the
/// mean number of claims that hold in a pair.
std::vector<double> claims_met(const SweepResults& results);

/// The number of claims whose pooled outcome, by the first or by the second measure, is neither
/// ClaimVerdict::kFails nor kUndecided.
struct NotFailing {
  std::size_t first = 0;
  std::size_t as_written = 0;
};

NotFailing not_failing(const SweepResults& results);

}  // namespace somato
