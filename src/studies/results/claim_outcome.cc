#include "somato/studies/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "base/core/contains.h"
#include "somato/studies/results.h"
#include "studies/results/claim_range.h"

namespace somato {
namespace {

// Differences of rounded values must not fail a bound that they meet.
constexpr double kBoundRounding = 1e-9;

constexpr std::string_view kMappedThings = "mapped_with ";

bool counts_explorations(const std::string& metric) {
  static const std::vector<std::string> names{"classes_separated", "samples_ambiguous",
                                              "neighbours_same_class"};
  return metric.starts_with(kMappedThings) ||
         contains(names, metric.substr(metric.rfind('.') + 1));  // npos + 1 is 0
}

bool has_class(const ProtocolResults& system, const std::string& name) {
  return std::any_of(system.runs.begin(), system.runs.end(),
                     [&](const Run& run) { return contains(run.labels, name); });
}

// Share of the values of one map's wrong groupings that meet the bounds.
double share_meeting(const Claim& claim, const Distribution& values) {
  double meeting = 0.0;
  double all = 0.0;
  for (const auto& [value, times] : values) {
    all += static_cast<double>(times);
    if (claim.is_met_by(value)) meeting += static_cast<double>(times);
  }
  return all > 0.0 ? meeting / all : 0.0;
}

std::size_t pairs_with_a_value(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(),
                                                [](double value) { return std::isfinite(value); }));
}

std::size_t recordings_in(const std::vector<std::size_t>& recordings) {
  return std::set<std::size_t>(recordings.begin(), recordings.end()).size();
}

std::string too_few(std::size_t count, const std::string& things, std::size_t needed) {
  return fmt::format("{} {}{}; {} are needed", count, things, count == 1 ? "" : "s", needed);
}

std::string range_words(const std::string& words, const std::optional<ClaimRange>& range) {
  return range ? fmt::format("{} {:.2f} to {:.2f}, ", words, range->low, range->high)
               : std::string();
}

ClaimVerdict verdict_by_share(const ClaimOutcome& outcome) {
  if (!reaches(outcome.share(), kHoldsFrom)) {
    return reaches(outcome.share(), kMostlyFrom) ? ClaimVerdict::kMostly : ClaimVerdict::kFails;
  }
  const bool chance = outcome.chance_share && reaches(*outcome.chance_share, kChanceFrom);
  return chance ? ClaimVerdict::kHoldsByChanceToo : ClaimVerdict::kHolds;
}

ClaimVerdict verdict_by_range(const ClaimOutcome& outcome) {
  const ClaimRange range = outcome.range().value();
  if (!range.contains(outcome.claim.published.value())) return ClaimVerdict::kFails;
  const bool narrower = range.width() < outcome.chance_range.value().width() - kBoundRounding;
  return narrower ? ClaimVerdict::kCompatible : ClaimVerdict::kCompatibleByChanceToo;
}

// Where the bounds are not included, the bound itself is no difference: an interval that only
// consists of it decides nothing.
ClaimVerdict verdict_by_mean(const ClaimOutcome& outcome) {
  const Claim& claim = outcome.claim;
  const ClaimRange range = outcome.range().value();
  const auto above = [](double a, double b) { return a > b + kBoundRounding; };
  if ((claim.at_least && above(*claim.at_least, range.high)) ||
      (claim.at_most && above(range.low, *claim.at_most))) {
    return ClaimVerdict::kFails;
  }
  const auto within = [&](double greater, double less) {
    return claim.bounds_included ? !above(less, greater) : above(greater, less);
  };
  const bool holds = (!claim.at_least || within(range.low, *claim.at_least)) &&
                     (!claim.at_most || within(*claim.at_most, range.high));
  return holds ? ClaimVerdict::kHolds : ClaimVerdict::kUndetermined;
}

}  // namespace

const std::vector<std::pair<ClaimVerdict, std::string>>& Choices<ClaimVerdict>::all() {
  static const std::vector<std::pair<ClaimVerdict, std::string>> names{
      {ClaimVerdict::kHolds, "holds"},
      {ClaimVerdict::kHoldsByChanceToo, "holds, but so does chance"},
      {ClaimVerdict::kCompatible, "compatible"},
      {ClaimVerdict::kCompatibleByChanceToo, "compatible, but no narrower than chance"},
      {ClaimVerdict::kMostly, "mostly"},
      {ClaimVerdict::kUndetermined, "not determined"},
      {ClaimVerdict::kFails, "fails"},
      {ClaimVerdict::kUndecided, "cannot be decided here"}};
  return names;
}

double ClaimOutcome::share() const {
  if (values.empty()) return 0.0;
  const auto holding = std::count_if(values.begin(), values.end(),
                                     [&](double value) { return claim.is_met_by(value); });
  return static_cast<double>(holding) / static_cast<double>(values.size());
}

std::optional<ClaimRange> ClaimOutcome::range() const {
  return claim.criterion == ClaimCriterion::kMean ? interval_of_mean(values, recordings)
                                                  : central_range(values);
}

double ClaimOutcome::mean() const {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto of_recordings = claim.criterion == ClaimCriterion::kMean
                                 ? mean_of_recordings(values, recordings)
                                 : std::nullopt;
  return of_recordings.value_or(Metric{claim.metric, values}.mean());
}

std::string ClaimOutcome::reason() const {
  if (!undecidable.empty()) return undecidable;
  const std::size_t pairs = pairs_with_a_value(values);
  if (pairs < kLeastPairs) return too_few(pairs, "pair", kLeastPairs);
  if (claim.criterion == ClaimCriterion::kShareOfPairs) return {};
  if (pairs < values.size()) {  // the others would be a selection
    return fmt::format("{} of {} pairs have no value", values.size() - pairs, values.size());
  }
  if (claim.criterion == ClaimCriterion::kCentralRange) {
    if (!claim.published) return "no published value";
    return chance_range ? std::string() : "no values by chance";
  }
  if (recordings.size() != values.size()) return "the recordings of the pairs are unknown";
  const std::size_t explored = recordings_in(recordings);
  return explored < kLeastRecordings ? too_few(explored, "recording", kLeastRecordings)
                                     : std::string();
}

ClaimVerdict ClaimOutcome::verdict() const {
  if (!reason().empty()) return ClaimVerdict::kUndecided;
  switch (claim.criterion) {
    case ClaimCriterion::kCentralRange:
      return verdict_by_range(*this);
    case ClaimCriterion::kMean:
      return verdict_by_mean(*this);
    case ClaimCriterion::kShareOfPairs:
      break;
  }
  return verdict_by_share(*this);
}

ClaimVerdict ClaimOutcome::verdict_as_written() const {
  return as_written.empty() ? verdict() : as_written.front().verdict();
}

std::string ClaimOutcome::summary() const {
  const bool of_mean = claim.criterion == ClaimCriterion::kMean;
  std::string bounds = fmt::format("{} {}", claim.measured(), claim.bounds());
  if (values.empty()) return bounds;
  return fmt::format("{}: mean {:.3f}, {}{}{:.0f} % of the pairs", bounds, mean(),
                     range_words(of_mean ? "interval of the mean" : "central 90 %", range()),
                     range_words("by chance", chance_range), 100.0 * share());
}

bool reaches(double share, double limit) {
  return share >= limit - kBoundRounding;
}

std::string reason_undecidable(const Claim& claim, const ProtocolResults& system) {
  const bool counts = counts_explorations(claim.metric);
  if (counts && claim.at_least && *claim.at_least > static_cast<double>(system.samples)) {
    return fmt::format("{} explorations; {:g} are needed", system.samples, *claim.at_least);
  }
  if (!claim.metric.starts_with(kMappedThings) || system.runs.empty()) return {};
  const std::string things = claim.metric.substr(kMappedThings.size());
  const std::size_t gap = things.find(' ');
  for (const std::string& name : {things.substr(0, gap), things.substr(gap + 1)}) {
    if (!has_class(system, name)) return fmt::format("no exploration of '{}'", name);
  }
  return {};
}

std::optional<double> chance_share_of(const Claim& claim, const Metric& by_chance) {
  if (by_chance.of_each.empty()) return {};
  double sum = 0.0;
  for (const Distribution& of_pair : by_chance.of_each) sum += share_meeting(claim, of_pair);
  return sum / static_cast<double>(by_chance.of_each.size());
}

std::optional<ClaimRange> chance_range_of(const Metric& by_chance) {
  Distribution all;
  for (const Distribution& of_pair : by_chance.of_each) {
    for (const auto& [value, times] : of_pair) {
      if (!std::isfinite(value)) return {};
      all[value] += times;
    }
  }
  return central_range(all);
}

}  // namespace somato
