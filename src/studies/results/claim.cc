#include "somato/studies/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "base/core/contains.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/results/claim_range.h"
#include "studies/results/metric_table.h"

namespace somato {
namespace {

// Differences of rounded values must not fail a bound that they meet.
constexpr double kClaimRounding = 1e-9;

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

bool has_judged_bound(const Claim& claim) {
  return claim.judged_at_least || claim.judged_at_most;
}

// Keys that would have no effect, or that lack another one.
Result<void> check_second_measure(const Claim& claim) {
  const auto refuse = [&](const std::string& what, const std::string& advice) -> Result<void> {
    return fail(ErrorKind::kUsage, what, claim.where, advice);
  };
  if (!claim.judged_metric.empty()) {
    SOMATO_TRY_VOID(check_metric_name(claim.judged_metric, claim.where));
    if (!has_judged_bound(claim)) {
      return refuse("'judged_metric' has no bound", "add judged_at_least or judged_at_most");
    }
  }
  if (claim.judged_by != ClaimCriterion::kCentralRange) return {};
  if (!claim.published || !std::isfinite(*claim.published)) {
    return refuse("a central range needs a published value", "add published = ...");
  }
  if (claim.compares() || has_judged_bound(claim)) {
    return refuse("a central range is of one metric, without other bounds",
                  "use judged_by = \"mean\" for a comparison, and remove the bounds");
  }
  return {};
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
  const bool narrower = range.width() < outcome.chance_range.value().width() - kClaimRounding;
  return narrower ? ClaimVerdict::kCompatible : ClaimVerdict::kCompatibleByChanceToo;
}

// A bound itself is no difference: an interval that only consists of it decides nothing.
ClaimVerdict verdict_by_mean(const ClaimOutcome& outcome) {
  const Claim& claim = outcome.claim;
  const ClaimRange range = outcome.range().value();
  const auto above = [](double a, double b) { return a > b + kClaimRounding; };
  if ((claim.at_least && above(*claim.at_least, range.high)) ||
      (claim.at_most && above(range.low, *claim.at_most))) {
    return ClaimVerdict::kFails;
  }
  const bool holds = (!claim.at_least || above(range.low, *claim.at_least)) &&
                     (!claim.at_most || above(*claim.at_most, range.high));
  return holds ? ClaimVerdict::kHolds : ClaimVerdict::kUndetermined;
}

std::string bounds_of_mean(const Claim& claim) {
  if (claim.at_least && claim.at_most) {
    return fmt::format("between {:g} and {:g}", *claim.at_least, *claim.at_most);
  }
  return claim.at_least ? fmt::format("above {:g}", *claim.at_least)
                        : fmt::format("below {:g}", claim.at_most.value_or(0.0));
}

Result<Claim> read_claim(const Table& table) {
  auto claim = read_parameters<Claim>(table);
  if (!claim) return claim;
  claim->where = table.where;
  const auto refuse = [&](const std::string& what, const std::string& advice) {
    return fail(ErrorKind::kUsage, what, table.where, advice);
  };
  if (claim->text.empty()) return refuse("the claim has no text", "add text = \"...\"");
  if (claim->metric.empty()) return refuse("the claim has no metric", "add metric = \"accuracy\"");
  SOMATO_TRY_VOID(check_metric_name(claim->metric, table.where));
  SOMATO_TRY_VOID(check_metric_name(claim->other_metric(), table.where));
  SOMATO_TRY_VOID(choice_named<Protocol>("protocol", claim->protocol, table.where));
  if (!claim->at_least && !claim->at_most) {
    return refuse("the claim has no bound", "add at_least = ... or at_most = ...");
  }
  SOMATO_TRY_VOID(check_second_measure(*claim));
  return claim;
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

const std::vector<std::pair<ClaimCriterion, std::string>>& Choices<ClaimCriterion>::all() {
  static const std::vector<std::pair<ClaimCriterion, std::string>> names{
      {ClaimCriterion::kShareOfPairs, "share_of_pairs"},
      {ClaimCriterion::kCentralRange, "central_range"},
      {ClaimCriterion::kMean, "mean"}};
  return names;
}

bool ClaimRange::contains(double value) const {
  return value >= low - kClaimRounding && value <= high + kClaimRounding;
}

std::optional<Claim> Claim::as_written() const {
  const bool by_share = judged_by == ClaimCriterion::kShareOfPairs;
  if (by_share && judged_metric.empty() && !has_judged_bound(*this)) return {};
  Claim second = *this;
  second.criterion = judged_by;
  second.judged_by = ClaimCriterion::kShareOfPairs;
  if (!judged_metric.empty()) {
    second.metric = judged_metric;
    second.published.reset();
  }
  if (has_judged_bound(*this)) {
    second.at_least = judged_at_least;
    second.at_most = judged_at_most;
  }
  second.judged_metric.clear();
  second.judged_at_least.reset();
  second.judged_at_most.reset();
  return second;
}

bool Claim::is_met_by(double value) const {
  return std::isfinite(value) && (!at_least || value >= *at_least - kClaimRounding) &&
         (!at_most || value <= *at_most + kClaimRounding);
}

std::string Claim::bounds() const {
  if (criterion == ClaimCriterion::kCentralRange) {
    return fmt::format("range with {:g}", published.value_or(0.0));
  }
  if (criterion == ClaimCriterion::kMean) return bounds_of_mean(*this);
  if (at_least && at_most) return fmt::format("between {:g} and {:g}", *at_least, *at_most);
  return at_least ? fmt::format("at least {:g}", *at_least)
                  : fmt::format("at most {:g}", at_most.value_or(0.0));
}

std::string Claim::other() const {
  if (!compares()) return {};
  const std::string& other_system = than_system.empty() ? system : than_system;
  if (than_variation.empty()) return other_system;
  return other_system == system ? than_variation : other_system + ", " + than_variation;
}

std::string Claim::measured() const {
  if (!compares()) return metric;
  const std::string subtracted = other_metric() == metric ? "that" : other_metric();
  return fmt::format("{} less {} of {}", metric, subtracted, other());
}

const Declarations<Claim>& Claim::declarations() {
  using P = Claim;
  static const auto declared =
      Declarations<P>()
          .add("text", &P::text, "", Range::any(), "The claim, in one sentence.")
          .add("paper", &P::paper, "", Range::any(),
               "Paper and section; empty if the claim is not from a paper.")
          .add("system", &P::system, "", Range::any(),
               "System that the claim is about; empty: the one that the file describes.")
          .add("variation", &P::variation, "", Range::any(),
               "Variation of the system; empty: the unchanged system.")
          .add("metric", &P::metric, "", Range::any(), "Name of the metric in results.json.")
          .add("protocol", &P::protocol, "", Range::any(),
               "Protocol under which the metric is measured.")
          .add("group", &P::group, "", Range::any(), "Label of the groups of leave_group_out.")
          .add("than_system", &P::than_system, "", Range::any(),
               "System with which the metric is compared, pair by pair; empty: the same system.")
          .add("than_variation", &P::than_variation, "", Range::any(),
               "Variation with which the metric is compared; empty with than_system: the unchanged "
               "system.")
          .add("than_metric", &P::than_metric, "", Range::any(),
               "Metric of the other side of the comparison; empty: the same one. Without "
               "than_system and than_variation, it is that of the same system and variation.")
          .add("published", &P::published, "", Range::any(),
               "Published value of the metric, from the paper's single map.")
          .add("at_least", &P::at_least, "", Range::any(),
               "Lower bound: the claim holds if the metric, or the difference, is at least this.")
          .add("at_most", &P::at_most, "", Range::any(),
               "Upper bound: the claim holds if the metric, or the difference, is at most this.")
          .add("judged_by", &P::judged_by, "", Range::any(),
               "A second measure of the claim, which is listed beside the share of pairs: whether "
               "the published count lies in the central 90 % of the pairs' values, or whether the "
               "interval of the mean over the recordings lies within the bounds.")
          .add("judged_metric", &P::judged_metric, "", Range::any(),
               "Metric of the second measure; empty: the same one.")
          .add("judged_at_least", &P::judged_at_least, "", Range::any(),
               "Lower bound of the second measure. If neither of its bounds is given, they are "
               "those of the claim.")
          .add("judged_at_most", &P::judged_at_most, "", Range::any(),
               "Upper bound of the second measure.")
          .add("contradicted_by", &P::contradicted_by, "", Range::any(),
               "Figure of the paper that contradicts the claim, with what it shows; empty: none.");
  return declared;
}

Result<std::vector<Claim>> read_claims(const Table& file) {
  std::vector<Claim> claims;
  const Table::Entry* entry = file.find("claim");
  if (!entry) return claims;
  const auto* tables = std::get_if<std::vector<Table>>(&entry->content);
  if (!tables) {
    return fail(ErrorKind::kUsage, "'claim' must be a list of tables", entry->where,
                "write each claim as a separate table [[claim]]");
  }
  for (const Table& table : *tables) {
    SOMATO_TRY(auto claim, read_claim(table));
    claims.push_back(std::move(claim));
  }
  return claims;
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

bool reaches(double share, double limit) {
  return share >= limit - kClaimRounding;
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
