#include "somato/studies/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/core/contains.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
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
  return claim;
}

}  // namespace

const std::vector<std::pair<ClaimVerdict, std::string>>& Choices<ClaimVerdict>::all() {
  static const std::vector<std::pair<ClaimVerdict, std::string>> names{
      {ClaimVerdict::kHolds, "holds"},
      {ClaimVerdict::kHoldsByChanceToo, "holds, but so does chance"},
      {ClaimVerdict::kMostly, "mostly"},
      {ClaimVerdict::kFails, "fails"},
      {ClaimVerdict::kUndecided, "cannot be decided here"}};
  return names;
}

bool Claim::is_met_by(double value) const {
  return std::isfinite(value) && (!at_least || value >= *at_least - kClaimRounding) &&
         (!at_most || value <= *at_most + kClaimRounding);
}

std::string Claim::bounds() const {
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
               "Upper bound: the claim holds if the metric, or the difference, is at most this.");
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

std::string ClaimOutcome::reason() const {
  if (!undecidable.empty()) return undecidable;
  const std::size_t pairs = pairs_with_a_value(values);
  if (pairs >= kLeastPairs) return {};
  return fmt::format("{} pair{}; {} are needed", pairs, pairs == 1 ? "" : "s", kLeastPairs);
}

ClaimVerdict ClaimOutcome::verdict() const {
  if (!reason().empty()) return ClaimVerdict::kUndecided;
  if (!reaches(share(), kHoldsFrom)) {
    return reaches(share(), kMostlyFrom) ? ClaimVerdict::kMostly : ClaimVerdict::kFails;
  }
  const bool chance = chance_share && reaches(*chance_share, kChanceFrom);
  return chance ? ClaimVerdict::kHoldsByChanceToo : ClaimVerdict::kHolds;
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

}  // namespace somato
