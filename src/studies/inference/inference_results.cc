#include "studies/inference/inference_results.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text/value_json.h"
#include "studies/results/results_json.h"
#include "studies/sweep/sweep_points.h"

namespace somato {
namespace {

using InferenceJson = nlohmann::ordered_json;

constexpr int kInferenceVersion = 1;
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

InferenceJson inferred_json(const InferenceResults& results, std::size_t number) {
  const SweepDescription& sweep = results.draws.sweep.sweep;
  const Unknown& unknown = sweep.unknowns[number];
  const InferredUnknown& inferred = results.inference.unknowns[number];
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
          {"system", results.draws.sweep.own_values[number]},
          {"cells", std::move(cells)},
          {"prior", summary_json(sweep, number, inferred.prior)},
          {"posterior", summary_json(sweep, number, inferred.posterior)},
          {"shrinkage", inferred.shrinkage()}};
}

InferenceJson dependences_json(const InferenceResults& results) {
  InferenceJson all = InferenceJson::array();
  const auto& unknowns = results.draws.sweep.sweep.unknowns;
  for (std::size_t a = 0; a < unknowns.size(); ++a) {
    for (std::size_t b = a + 1; b < unknowns.size(); ++b) {
      all.push_back({{"first", unknowns[a].name},
                     {"second", unknowns[b].name},
                     {"correlation", results.inference.correlations(a, b)}});
    }
  }
  return all;
}

InferenceJson calibration_json(const InferenceResults& results) {
  const Calibration& calibration = results.inference.calibration;
  InferenceJson unknowns = InferenceJson::array();
  for (std::size_t u = 0; u < calibration.covered.size(); ++u) {
    unknowns.push_back({{"name", results.draws.sweep.sweep.unknowns[u].name},
                        {"covered", calibration.covered[u]},
                        {"uniform_p", calibration.uniform_p[u]},
                        {"ranks", places_of(calibration.ranks, u)}});
  }
  return {{"truths", calibration.ranks.rows()}, {"unknowns", std::move(unknowns)}};
}

InferenceJson supported_claim_json(const InferenceResults& results, std::size_t number) {
  const ClaimShares& shares = results.claims[number];
  InferenceJson json = detail::claim_json(results.draws.sweep.claims[number]);
  json["prior"] = or_null(shares.prior);
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

InferenceJson bodies_json(const InferenceResults& results) {
  InferenceJson bodies = InferenceJson::array();
  for (const SweepPointResults& point : results.fresh.points) {
    InferenceJson values = InferenceJson::object();
    for (std::size_t u = 0; u < point.point.size(); ++u) {
      values[results.draws.sweep.sweep.unknowns[u].name] = to_json_value(point.point[u]->value);
    }
    bodies.push_back(std::move(values));
  }
  return bodies;
}

InferenceJson rule_json(const InferenceParameters& inference) {
  return {{"accepted", inference.accepted}, {"adjusted", inference.adjusted},
          {"truths", inference.truths},     {"bodies", inference.bodies},
          {"pairs", inference.pairs},       {"seed", inference.seed}};
}

template <typename Entry>
InferenceJson list_of(std::size_t count, const Entry& entry) {
  InferenceJson list = InferenceJson::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(entry(i));
  return list;
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
      {"unknowns", list_of(results.inference.unknowns.size(),
                           [&](std::size_t i) { return inferred_json(results, i); })},
      {"dependences", dependences_json(results)},
      {"calibration", calibration_json(results)},
      {"claims", list_of(results.claims.size(),
                         [&](std::size_t i) { return supported_claim_json(results, i); })},
      {"conflicts",
       list_of(results.conflicts.size(),
               [&](std::size_t i) { return conflict_json(results, results.conflicts[i]); })},
      {"joint",
       {{"claims", sweep.claims.size()},
        {"prior", joint_json(results.draws)},
        {"fresh", joint_json(results.fresh)}}},
      {"bodies", bodies_json(results)}};
  return json.dump(-1, ' ', false, InferenceJson::error_handler_t::replace) + "\n";
}

}  // namespace somato
