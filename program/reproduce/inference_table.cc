#include "reproduce/result_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "studies/sweep/sweep_points.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string short_value(const SweepDescription& sweep, std::size_t unknown, double place) {
  const Value value = value_at_place(sweep, unknown, place);
  const auto* number = std::get_if<double>(&value.content);
  return number ? fmt::format("{:.3g}", *number) : to_toml(value);
}

std::string most_likely(const SweepDescription& sweep, const Unknown& unknown,
                        const InferredUnknown& inferred) {
  const auto& shares = inferred.posterior_shares;
  const auto best =
      static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  return fmt::format("{} in {:.0f} % (prior {:.0f} %)",
                     to_toml(sweep_cells(sweep, unknown)[best].from), 100.0 * shares[best],
                     100.0 * inferred.prior_shares[best]);
}

std::string unknown_line(const SweepDescription& sweep, const Inference& inference,
                         std::size_t number) {
  const Unknown& unknown = sweep.unknowns[number];
  const InferredUnknown& inferred = inference.unknowns[number];
  const std::string values =
      unknown.parameters.is_range()
          ? fmt::format("{} ({} to {})", short_value(sweep, number, inferred.posterior.median),
                        short_value(sweep, number, inferred.posterior.low),
                        short_value(sweep, number, inferred.posterior.high))
          : most_likely(sweep, unknown, inferred);
  return fmt::format("  {:>5.2f}  {}: {}\n", inferred.shrinkage(), unknown.name, values);
}

std::string percent(std::optional<double> share) {
  return share ? fmt::format("{:.0f} %", 100.0 * *share) : "-";
}

std::string verdict_text(const ClaimShares& shares) {
  const auto& verdict = shares.fresh_verdict_as_written;
  return verdict ? " (" + choice_name(*verdict) + ")" : "";
}

std::string claim_line(const InferenceResults& results, std::size_t number) {
  const Claim& claim = results.draws.sweep.claims[number];
  const ClaimShares& shares = results.claims[number];
  const std::string system =
      claim.variation.empty() ? claim.system : claim.system + ", " + claim.variation;
  return fmt::format("  {:>6}  {:>6}  {:>6}  {:>6}  {:11}  {}: {}\n", percent(shares.prior),
                     percent(shares.fresh), percent(shares.left_out), percent(shares.chance),
                     choice_name(shares.support()), system, claim.text + verdict_text(shares));
}

double mean_met(const SweepResults& results) {
  const std::vector<double> sums = claims_met(results);
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  return sums.empty() ? 0.0 : sum / static_cast<double>(sums.size());
}

std::string joint_line(const InferenceResults& results) {
  const NotFailing counts = not_failing(results.fresh);
  return fmt::format(
      "\nOf {}, {:.1f} hold in a pair of a setting of the prior, {:.1f} in a fresh pair of {} of "
      "the "
      "posterior. Of all fresh pairs together, {} do not fail, by their second measures {}.\n",
      counted(results.claims.size(), "claim"), mean_met(results.draws), mean_met(results.fresh),
      counted(results.fresh.points.size(), "setting"), counts.first, counts.as_written);
}

}  // namespace

std::string inferred_unknowns_table(const SweepDescription& sweep, const Inference& inference,
                                    bool adjusted) {
  std::string text;
  if (adjusted && !inference.posterior.is_adjusted) {
    text +=
        "These are too few for the regression, so that their settings are not adjusted; more draws "
        "or a larger share 'accepted' would permit it.\n\n";
  }
  text +=
      "  width  unknown, with the median and the central 90 % of the posterior (width: relative to "
      "the prior)\n";
  for (std::size_t i = 0; i < inference.unknowns.size(); ++i)
    text += unknown_line(sweep, inference, i);
  return text;
}

std::string inference_table(const InferenceResults& results) {
  const SystemSweep& sweep = results.draws.sweep;
  std::string text = fmt::format(
      "{}: {} with {} each; the {} nearest to {} accepted\n\n", names_of(sweep),
      counted(results.draws.points.size(), "draw"), counted(sweep.sweep.sweep.pairs, "pair"),
      results.inference.posterior.size(), counted(results.targets.targets.size(), "target"));
  text +=
      inferred_unknowns_table(sweep.sweep, results.inference, results.targets.inference.adjusted);
  text += fmt::format("\n  {:>6}  {:>6}  {:>6}  {:>6}  {:11}  claim\n", "prior", "fresh", "others",
                      "chance", "");
  for (std::size_t i = 0; i < results.claims.size(); ++i) text += claim_line(results, i);
  return text + joint_line(results) +
         "prior: share of all pairs; fresh: of posterior bodies with fresh seeds; others: "
         "predicted from the targets "
         "with other measures; in parentheses the verdict on all fresh pairs.\n";
}

}  // namespace somato::program
