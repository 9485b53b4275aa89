#include "studies/inference/claim_support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace somato {
namespace {

constexpr double kUnjudged = std::numeric_limits<double>::quiet_NaN();
constexpr double kConflictingFrom = -3.0;  // standard deviations

// The weighted share of those that can be judged.
std::optional<double> share_met(const MetClaims& met, const Posterior& posterior) {
  double meeting = 0.0;
  double judged = 0.0;
  for (std::size_t i = 0; i < posterior.size(); ++i) {
    const double value = met[posterior.simulations[i]];
    if (std::isnan(value)) continue;
    meeting += posterior.weights[i] * value;
    judged += posterior.weights[i];
  }
  return judged > 0.0 ? std::optional(meeting / judged) : std::nullopt;
}

std::optional<double> share_met(const MetClaims& met) {
  double meeting = 0.0;
  double judged = 0.0;
  for (const double value : met) {
    if (std::isnan(value)) continue;
    meeting += value;
    judged += 1.0;
  }
  return judged > 0.0 ? std::optional(meeting / judged) : std::nullopt;
}

// The posterior without the targets that have the measure of the claim; nothing without any other.
std::optional<Posterior> without_own_targets(const Claim& claim, const Simulations& all,
                                             const Targets& targets) {
  Observation observed;
  std::vector<std::size_t> columns;
  for (std::size_t t = 0; t < targets.targets.size(); ++t) {
    if (is_about(claim, targets.targets[t])) continue;
    observed.values.push_back(*targets.targets[t].observed);
    observed.scales.push_back(*targets.targets[t].scale);
    columns.push_back(t);
  }
  if (columns.empty()) return {};
  Simulations others{all.places, Matrix<double>(all.draw.size(), columns.size()), all.draw,
                     all.is_continuous, all.group};
  for (std::size_t i = 0; i < all.draw.size(); ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      others.statistics(i, c) = all.statistics(i, columns[c]);
  }
  return accept_nearest(others, observed, {targets.inference.accepted, false});
}

std::optional<double> mean_chance(const SweepResults& results, std::size_t claim) {
  double sum = 0.0;
  double points = 0.0;
  for (const SweepPointResults& point : results.points) {
    const auto& outcome = point.claims[claim];
    if (!outcome || !outcome->chance_share) continue;
    sum += *outcome->chance_share;
    points += 1.0;
  }
  return points > 0.0 ? std::optional(sum / points) : std::nullopt;
}

std::optional<ClaimValues> values_of(const SweepResults& results, std::size_t claim) {
  std::vector<double> all;
  for (const SweepPointResults& point : results.points) {
    const auto& outcome = point.claims[claim];
    if (outcome) all.insert(all.end(), outcome->values.begin(), outcome->values.end());
  }
  if (all.empty()) return {};
  std::sort(all.begin(), all.end());
  return ClaimValues{all.front(), all[(all.size() - 1) / 2], all.back()};
}

std::size_t judged_draws(const SweepResults& results, std::size_t claim) {
  return static_cast<std::size_t>(std::count_if(
      results.points.begin(), results.points.end(),
      [&](const SweepPointResults& point) { return point.claims[claim].has_value(); }));
}

std::optional<ClaimConflict> conflict_between(const MetClaims& a, const MetClaims& b,
                                              double simulations_of_draw, double least_expected) {
  double judged = 0.0;
  double met_a = 0.0;
  double met_b = 0.0;
  ClaimConflict conflict;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    judged += 1.0;
    met_a += a[i];
    met_b += b[i];
    conflict.together += a[i] * b[i];
  }
  if (judged < 2.0) return {};
  conflict.expected = met_a * met_b / judged;
  // The number of both is hypergeometric if the claims, and the simulations, are independent.
  const double variance = simulations_of_draw * conflict.expected * (judged - met_a) *
                          (judged - met_b) / (judged * (judged - 1.0));
  if (conflict.expected < least_expected || variance <= 0.0) return {};
  conflict.deviations = (conflict.together - conflict.expected) / std::sqrt(variance);
  return conflict.deviations < kConflictingFrom ? std::optional(conflict) : std::nullopt;
}

bool is_met_or_open(ClaimVerdict verdict) {
  return verdict != ClaimVerdict::kFails && verdict != ClaimVerdict::kUndecided;
}

// Adds the pairs of a further point; recordings of different points are different.
void add_outcome(const ClaimOutcome& more, std::size_t first_recording, ClaimOutcome& all) {
  all.values.insert(all.values.end(), more.values.begin(), more.values.end());
  for (const std::size_t recording : more.recordings) {
    all.recordings.push_back(first_recording + recording);
  }
  if (!more.chance_range) return;
  const bool is_narrower =
      !all.chance_range || more.chance_range->width() < all.chance_range->width();
  if (is_narrower) all.chance_range = more.chance_range;
}

std::size_t recordings_before(const ClaimOutcome& outcome) {
  const auto& numbers = outcome.recordings;
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1;
}

void pool(const ClaimOutcome& more, ClaimOutcome& all) {
  const std::size_t first = recordings_before(all);
  add_outcome(more, first, all);
  for (std::size_t i = 0; i < std::min(all.as_written.size(), more.as_written.size()); ++i) {
    add_outcome(more.as_written[i], first, all.as_written[i]);
  }
}

}  // namespace

const std::vector<std::pair<ClaimSupport, std::string>>& Choices<ClaimSupport>::all() {
  static const std::vector<std::pair<ClaimSupport, std::string>> names{
      {ClaimSupport::kExplained, "explained"},
      {ClaimSupport::kReachable, "reachable"},
      {ClaimSupport::kExcluded, "excluded"},
      {ClaimSupport::kNotDecided, "not decided"}};
  return names;
}

MetClaims met_by_simulations(const SweepResults& results, std::size_t claim) {
  MetClaims met;
  for (const SweepPointResults& point : results.points) {
    const auto& outcome = point.claims[claim];
    for (std::size_t pair = 0; pair < point.pairs(); ++pair) {
      const bool judged = outcome && pair < outcome->values.size();
      const bool is_met = judged && outcome->claim.is_met_by(outcome->values[pair]);
      met.push_back(judged ? (is_met ? 1.0 : 0.0) : kUnjudged);
    }
  }
  return met;
}

ClaimSupport ClaimShares::support() const {
  const bool by_chance = fresh_chance && reaches(*fresh_chance, kExplainedFrom);
  if (fresh && fresh_pairs >= kLeastPairs && reaches(*fresh, kExplainedFrom) && !by_chance) {
    return ClaimSupport::kExplained;
  }
  if (!prior) return ClaimSupport::kNotDecided;
  if (*prior >= kExcludedBelow || fresh.value_or(0.0) >= kExcludedBelow) {
    return ClaimSupport::kReachable;
  }
  return draws >= kDecidingDraws ? ClaimSupport::kExcluded : ClaimSupport::kNotDecided;
}

ClaimShares shares_of(const SweepResults& results, std::size_t claim,
                      const Simulations& simulations, const Posterior& posterior,
                      const Targets& targets, const SweepResults& fresh) {
  const MetClaims met = met_by_simulations(results, claim);
  ClaimShares shares;
  shares.prior = share_met(met);
  shares.values = values_of(results, claim);
  shares.posterior = share_met(met, posterior);
  const auto others = without_own_targets(results.sweep.claims[claim], simulations, targets);
  if (others) shares.left_out = share_met(met, *others);
  const MetClaims met_fresh = met_by_simulations(fresh, claim);
  shares.fresh = share_met(met_fresh);
  shares.fresh_pairs = static_cast<std::size_t>(std::count_if(
      met_fresh.begin(), met_fresh.end(), [](double one) { return !std::isnan(one); }));
  if (const auto pooled = pooled_outcome(fresh, claim)) {
    shares.fresh_verdict = pooled->verdict();
    shares.fresh_verdict_as_written = pooled->verdict_as_written();
  }
  shares.chance = mean_chance(results, claim);
  shares.fresh_chance = mean_chance(fresh, claim);
  shares.draws = judged_draws(results, claim);
  return shares;
}

std::optional<ClaimOutcome> pooled_outcome(const SweepResults& results, std::size_t claim) {
  std::optional<ClaimOutcome> all;
  for (const SweepPointResults& point : results.points) {
    const auto& outcome = point.claims[claim];
    if (!outcome) continue;
    if (all) {
      pool(*outcome, *all);
    } else {
      all = outcome;
    }
  }
  return all;
}

NotFailing not_failing(const SweepResults& results) {
  NotFailing counts;
  for (std::size_t claim = 0; claim < results.sweep.claims.size(); ++claim) {
    const auto outcome = pooled_outcome(results, claim);
    if (!outcome) continue;
    if (is_met_or_open(outcome->verdict())) ++counts.first;
    if (is_met_or_open(outcome->verdict_as_written())) ++counts.as_written;
  }
  return counts;
}

std::vector<ClaimConflict> conflicts_of(const std::vector<MetClaims>& met,
                                        double simulations_of_draw, double least_expected) {
  std::vector<ClaimConflict> conflicts;
  for (std::size_t a = 0; a < met.size(); ++a) {
    for (std::size_t b = a + 1; b < met.size(); ++b) {
      auto conflict = conflict_between(met[a], met[b], simulations_of_draw, least_expected);
      if (!conflict) continue;
      conflict->first = a;
      conflict->second = b;
      conflicts.push_back(*conflict);
    }
  }
  std::sort(conflicts.begin(), conflicts.end(), [](const ClaimConflict& a, const ClaimConflict& b) {
    return std::tuple(a.deviations, a.first, a.second) <
           std::tuple(b.deviations, b.first, b.second);
  });
  return conflicts;
}

std::vector<double> claims_met(const SweepResults& results) {
  std::vector<double> sums;
  sums.reserve(results.points.size());
  for (const SweepPointResults& point : results.points) {
    double sum = 0.0;
    for (const auto& outcome : point.claims) sum += outcome ? outcome->share() : 0.0;
    sums.push_back(sum);
  }
  return sums;
}

}  // namespace somato
