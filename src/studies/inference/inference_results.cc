#include "studies/inference/inference_results.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/core/contains.h"
#include "base/text/value_json.h"
#include "studies/results/results_json.h"
#include "studies/sweep/sweep_points.h"
#include "systems/signals/mean_and_spread.h"

namespace somato {
namespace {

using InferenceJson = nlohmann::ordered_json;

constexpr int kInferenceVersion = 1;
constexpr int kMatchVersion = 1;
constexpr double kLeastExpected =
    5.0;  // simulations; the usual least count of a normal approximation

InferenceJson or_null(std::optional<double> number) {
  return number ? InferenceJson(*number) : InferenceJson(nullptr);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  double count = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

InferenceJson or_null(std::optional<ClaimVerdict> verdict) {
  return verdict ? InferenceJson(choice_name(*verdict)) : InferenceJson(nullptr);
}

template <typename Entry>
InferenceJson list_of(std::size_t count, const Entry& entry) {
  InferenceJson list = InferenceJson::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(entry(i));
  return list;
}

InferenceJson target_json(const InferenceResults& results, std::size_t number) {
  const Target& target = results.targets.targets[number];
  const auto& statistics = results.inference.simulations.statistics;
  return {{"text", target.text},
          {"paper", target.paper},
          {"system", target.system},
          {"variation", target.variation},
          {"metric", target.metric},
          {"protocol", target.protocol},
          {"observed", *target.observed},
          {"scale", *target.scale},
          {"prior", mean_of(places_of(statistics, number))},
          {"posterior", results.inference.predicted[number]}};
}

InferenceJson summary_json(const SweepDescription& sweep, std::size_t unknown,
                           const PlaceSummary& summary) {
  return {{"low", to_json_value(value_at_place(sweep, unknown, summary.low))},
          {"median", to_json_value(value_at_place(sweep, unknown, summary.median))},
          {"high", to_json_value(value_at_place(sweep, unknown, summary.high))}};
}

InferenceJson inferred_json(const SystemSweep& swept, const Inference& inference,
                            std::size_t number) {
  const SweepDescription& sweep = swept.sweep;
  const Unknown& unknown = sweep.unknowns[number];
  const InferredUnknown& inferred = inference.unknowns[number];
  InferenceJson cells = InferenceJson::array();
  const std::vector<SweepCell> all = sweep_cells(sweep, unknown);
  for (std::size_t i = 0; i < all.size(); ++i) {
    cells.push_back({{"from", to_json_value(all[i].from)},
                     {"to", to_json_value(all[i].to)},
                     {"prior", inferred.prior_shares[i]},
                     {"posterior", inferred.posterior_shares[i]}});
  }
  return {{"name", unknown.name},
          {"key", unknown.parameters.key},
          {"text", unknown.parameters.text},
          {"system", swept.own_values[number]},
          {"cells", std::move(cells)},
          {"prior", summary_json(sweep, number, inferred.prior)},
          {"posterior", summary_json(sweep, number, inferred.posterior)},
          {"shrinkage", inferred.shrinkage()}};
}

InferenceJson dependences_json(const std::vector<Unknown>& unknowns, const Inference& inference) {
  InferenceJson all = InferenceJson::array();
  for (std::size_t a = 0; a < unknowns.size(); ++a) {
    for (std::size_t b = a + 1; b < unknowns.size(); ++b) {
      all.push_back({{"first", unknowns[a].name},
                     {"second", unknowns[b].name},
                     {"correlation", inference.correlations(a, b)}});
    }
  }
  return all;
}

InferenceJson calibration_json(const std::vector<Unknown>& names, const Calibration& calibration) {
  InferenceJson unknowns = InferenceJson::array();
  for (std::size_t u = 0; u < calibration.covered.size(); ++u) {
    unknowns.push_back({{"name", names[u].name},
                        {"covered", calibration.covered[u]},
                        {"uniform_p", calibration.uniform_p[u]},
                        {"ranks", places_of(calibration.ranks, u)}});
  }
  return {{"truths", calibration.ranks.rows()}, {"unknowns", std::move(unknowns)}};
}

InferenceJson values_json(const std::optional<ClaimValues>& values) {
  if (!values) return nullptr;
  return {{"least", values->least}, {"median", values->median}, {"greatest", values->greatest}};
}

InferenceJson supported_claim_json(const InferenceResults& results, std::size_t number) {
  const ClaimShares& shares = results.claims[number];
  InferenceJson json = detail::claim_json(results.draws.sweep.claims[number]);
  json["prior"] = or_null(shares.prior);
  json["values"] = values_json(shares.values);
  json["posterior"] = or_null(shares.posterior);
  json["left_out"] = or_null(shares.left_out);
  json["fresh"] = or_null(shares.fresh);
  json["fresh_verdict"] = or_null(shares.fresh_verdict);
  json["fresh_verdict_as_written"] = or_null(shares.fresh_verdict_as_written);
  json["chance"] = or_null(shares.chance);
  json["fresh_chance"] = or_null(shares.fresh_chance);
  json["draws"] = shares.draws;
  json["support"] = choice_name(shares.support());
  return json;
}

InferenceJson conflict_json(const InferenceResults& results, const ClaimConflict& conflict) {
  const std::vector<Claim>& claims = results.draws.sweep.claims;
  const auto name = [&](std::size_t claim) {
    return InferenceJson{{"system", claims[claim].system},
                         {"variation", claims[claim].variation},
                         {"text", claims[claim].text}};
  };
  return {{"first", name(conflict.first)},
          {"second", name(conflict.second)},
          {"together", conflict.together},
          {"expected", conflict.expected},
          {"deviations", conflict.deviations}};
}

InferenceJson joint_json(const SweepResults& results) {
  std::vector<double> sums = claims_met(results);
  std::sort(sums.begin(), sums.end());
  const NotFailing counts = not_failing(results);
  return {{"bodies", sums.size()},
          {"mean", mean_of(sums)},
          {"sums", sums},
          {"not_failing", counts.first},
          {"not_failing_as_written", counts.as_written}};
}

InferenceJson body_json(const std::vector<Unknown>& unknowns, const SweepPoint& point) {
  InferenceJson values = InferenceJson::object();
  for (std::size_t u = 0; u < point.size(); ++u) {
    values[unknowns[u].name] = to_json_value(point[u]->value);
  }
  return values;
}

InferenceJson rule_json(const InferenceParameters& inference) {
  return {{"accepted", inference.accepted}, {"adjusted", inference.adjusted},
          {"truths", inference.truths},     {"bodies", inference.bodies},
          {"pairs", inference.pairs},       {"seed", inference.seed}};
}

InferenceJson number_json(double number) {
  return std::isfinite(number) ? InferenceJson(number) : InferenceJson(nullptr);
}

InferenceJson distance_json(const TouchDistance& distance) {
  return {{"median", number_json(distance.median)},
          {"root_mean_square", number_json(distance.root_mean_square)},
          {"within_two", number_json(distance.within_two)}};
}

// The distances that this share of the draws is below, each measure by itself.
TouchDistance quantile_of_draws(const Match& match, double share) {
  const std::vector<double> equal(match.of_draws.size(), 1.0);
  const auto quantile = [&](double TouchDistance::* measure) {
    std::vector<double> values;
    values.reserve(match.of_draws.size());
    for (const TouchDistance& distance : match.of_draws) values.push_back(distance.*measure);
    return weighted_quantile(values, equal, share);
  };
  return {quantile(&TouchDistance::median), quantile(&TouchDistance::root_mean_square),
          quantile(&TouchDistance::within_two)};
}

InferenceJson distances_json(const Match& match) {
  return {{"real", distance_json(match.by_chance)},
          {"system", distance_json(mean_distance(match, match.system))},
          {"prior", distance_json(quantile_of_draws(match, 0.5))},
          {"nearest_twentieth", distance_json(quantile_of_draws(match, 0.05))},
          {"posterior", distance_json(mean_distance(match, match.fresh))}};
}

double mean_of_column(const Matrix<double>& statistics, std::size_t column) {
  MeanAndSpread mean;
  for (std::size_t i = 0; i < statistics.rows(); ++i) mean.add(statistics(i, column));
  return mean.mean();
}

InferenceJson statistic_json(const Match& match, std::size_t number) {
  const Statistic& name = match.touch.names[number];
  return {{"channel", name.channel},
          {"measure", name.measure},
          {"thing", name.thing},
          {"fitted", number_json(match.touch.fitted[number])},
          {"held_out", number_json(match.touch.held_out[number])},
          {"scale", number_json(match.touch.scales[number])},
          {"system", number_json(mean_of_column(match.system, number))},
          {"prior", number_json(mean_of_column(match.draws.statistics, number))},
          {"posterior", number_json(mean_of_column(match.fresh, number))},
          {"explained", number_json(match.explained[number])},
          {"out_of_reach", static_cast<bool>(match.out_of_reach[number])},
          {"left_out", match.left_out[number]}};
}

InferenceJson ignored_json(const ComparedTouch& compared) {
  return list_of(compared.ignored.size(), [&](std::size_t i) {
    return InferenceJson{{"name", compared.ignored[i].name},
                         {"reason", compared.ignored[i].reason}};
  });
}

InferenceJson compared_json(const ComparedTouch& compared) {
  InferenceJson channels = InferenceJson::array();
  for (const FeaturedChannel& channel : compared.channels) channels.push_back(channel.name);
  return {{"channels", std::move(channels)},
          {"ignored", ignored_json(compared)},
          {"label", compared.label},
          {"things", compared.things}};
}

InferenceJson predicted_json(const Match& match, std::size_t unknown) {
  const RidgePrediction& summary = match.summaries[unknown];
  InferenceJson json = inferred_json(match.draws.sweep, match.inference, unknown);
  json["outside"] = contains(match.outside, match.draws.sweep.sweep.unknowns[unknown].name);
  json["predicted"] = summary.of_given;
  json["error"] = summary.error;
  json["penalty"] = summary.penalty;
  return json;
}

std::string text_of(const InferenceJson& json) {
  return json.dump(-1, ' ', false, InferenceJson::error_handler_t::replace) + "\n";
}

}  // namespace

InferenceResults with_claims(SweepResults draws, Targets targets, Inference inference,
                             SweepResults fresh) {
  InferenceResults results{
      std::move(draws), std::move(targets), std::move(inference), std::move(fresh), {}, {}};
  std::vector<MetClaims> met;
  for (std::size_t claim = 0; claim < results.draws.sweep.claims.size(); ++claim) {
    met.push_back(met_by_simulations(results.draws, claim));
    results.claims.push_back(shares_of(results.draws, claim, results.inference.simulations,
                                       results.inference.posterior, results.targets,
                                       results.fresh));
  }
  const auto count = static_cast<double>(std::max<std::size_t>(results.draws.points.size(), 1));
  const auto simulations = static_cast<double>(results.inference.simulations.draw.size());
  results.conflicts = conflicts_of(met, std::max(1.0, simulations / count), kLeastExpected);
  return results;
}

std::string to_json(const InferenceResults& results) {
  const SystemSweep& sweep = results.draws.sweep;
  const InferenceJson json = {
      {"version", kInferenceVersion},
      {"systems", sweep.systems},
      {"draws", results.draws.points.size()},
      {"pairs", sweep.sweep.sweep.pairs},
      {"accepted", results.inference.posterior.size()},
      {"adjusted", results.inference.posterior.is_adjusted},
      {"inference", rule_json(results.targets.inference)},
      {"targets", list_of(results.targets.targets.size(),
                          [&](std::size_t i) { return target_json(results, i); })},
      {"unknowns",
       list_of(results.inference.unknowns.size(),
               [&](std::size_t i) { return inferred_json(sweep, results.inference, i); })},
      {"dependences", dependences_json(sweep.sweep.unknowns, results.inference)},
      {"calibration", calibration_json(sweep.sweep.unknowns, results.inference.calibration)},
      {"claims", list_of(results.claims.size(),
                         [&](std::size_t i) { return supported_claim_json(results, i); })},
      {"conflicts",
       list_of(results.conflicts.size(),
               [&](std::size_t i) { return conflict_json(results, results.conflicts[i]); })},
      {"joint",
       {{"claims", sweep.claims.size()},
        {"prior", joint_json(results.draws)},
        {"fresh", joint_json(results.fresh)}}},
      {"bodies", list_of(results.fresh.points.size(), [&](std::size_t i) {
         return body_json(sweep.sweep.unknowns, results.fresh.points[i].point);
       })}};
  return text_of(json);
}

std::string to_json(const Match& match) {
  const SystemSweep& sweep = match.draws.sweep;
  const std::vector<Unknown>& unknowns = sweep.sweep.unknowns;
  const InferenceJson json = {
      {"version", kMatchVersion},
      {"body", names_of(sweep)},
      {"draws", match.draws.points.size()},
      {"accepted", match.inference.posterior.size()},
      {"adjusted", match.inference.posterior.is_adjusted},
      {"not_adjusted", match.not_adjusted},
      {"inference", rule_json(match.parameters)},
      {"compared", compared_json(match.touch.compared)},
      {"explorations",
       {{"fitted", match.touch.fitted_explorations},
        {"held_out", match.touch.held_out_explorations}}},
      {"distances", distances_json(match)},
      {"unknowns",
       list_of(unknowns.size(), [&](std::size_t i) { return predicted_json(match, i); })},
      {"dependences", dependences_json(unknowns, match.inference)},
      {"calibration", calibration_json(unknowns, match.inference.calibration)},
      {"statistics",
       list_of(match.touch.names.size(), [&](std::size_t i) { return statistic_json(match, i); })},
      {"bodies", list_of(match.bodies.size(),
                         [&](std::size_t i) { return body_json(unknowns, match.bodies[i]); })}};
  return text_of(json);
}

}  // namespace somato
