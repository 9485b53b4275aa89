#include "somato/studies/claim.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "somato/studies/study_parameters.h"
#include "studies/results/metric_table.h"

namespace somato {
namespace {

// Differences of rounded values must not fail a bound that they meet.
constexpr double kClaimRounding = 1e-9;

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
    second.bounds_included = judged_by != ClaimCriterion::kMean;
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
  if (at_least && at_most) return fmt::format("between {:g} and {:g}", *at_least, *at_most);
  if (at_least) return fmt::format("{} {:g}", bounds_included ? "at least" : "above", *at_least);
  return fmt::format("{} {:g}", bounds_included ? "at most" : "below", at_most.value_or(0.0));
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
               "Lower bound of the second measure, which the interval of a mean must not touch. If "
               "neither of its bounds is given, they are those of the claim, which are included.")
          .add("judged_at_most", &P::judged_at_most, "", Range::any(),
               "Upper bound of the second measure, which the interval of a mean must not touch.")
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

}  // namespace somato
