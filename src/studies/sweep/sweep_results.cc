#include "studies/sweep/sweep_results.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "base/core/contains.h"
#include "base/text/value_json.h"
#include "studies/results/results_json.h"

namespace somato {
namespace {

using SweepJson = nlohmann::ordered_json;

constexpr int kSweepVersion = 1;

// The points at which a claim can be judged.
struct JudgedPoints {
  std::vector<const SweepPoint*> points;
  std::vector<double> shares;

  double mean() const {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    return shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
  }
};

JudgedPoints judged_points(const SweepResults& results, std::size_t claim) {
  JudgedPoints judged;
  for (const SweepPointResults& point : results.points) {
    if (!point.claims[claim]) continue;
    judged.points.push_back(&point.point);
    judged.shares.push_back(point.claims[claim]->share());
  }
  return judged;
}

// Those at which the unknown was moved.
JudgedPoints moved_points(const JudgedPoints& all, std::size_t unknown) {
  JudgedPoints moved;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    if (!(*all.points[i])[unknown]) continue;
    moved.points.push_back(all.points[i]);
    moved.shares.push_back(all.shares[i]);
  }
  return moved;
}

std::vector<CellOutcome> outcomes_in(std::size_t cells, const JudgedPoints& points,
                                     std::size_t unknown) {
  std::vector<JudgedPoints> in_cell(cells);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    in_cell[(*points.points[i])[unknown]->cell].shares.push_back(points.shares[i]);
  }
  std::vector<CellOutcome> outcomes;
  outcomes.reserve(cells);
  for (const JudgedPoints& cell : in_cell) outcomes.push_back({cell.shares.size(), cell.mean()});
  return outcomes;
}

// For the unchanged system, if it is a point.
double change_over(const std::vector<CellOutcome>& cells, std::optional<double> system_share) {
  std::vector<double> shares;
  if (system_share) shares.push_back(*system_share);
  for (const CellOutcome& cell : cells) {
    if (cell.points > 0) shares.push_back(cell.share);
  }
  if (shares.empty()) return 0.0;
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  return *most - *least;
}

UnknownEffect effect_of(const SweepResults& results, const JudgedPoints& judged,
                        std::size_t unknown, std::optional<double> system_share) {
  const SweepDescription& sweep = results.sweep.sweep;
  const JudgedPoints moved = moved_points(judged, unknown);
  const std::size_t cells = sweep_cells(sweep, sweep.unknowns[unknown]).size();
  UnknownEffect effect{outcomes_in(cells, moved, unknown), 0.0, {}};
  effect.change = change_over(effect.cells, system_share);
  if (sweep.sweep.design == SweepDesign::kOneAtATime) return effect;
  std::vector<std::size_t> numbers;
  numbers.reserve(moved.points.size());
  for (const SweepPoint* point : moved.points) numbers.push_back((*point)[unknown]->cell);
  effect.order = first_order(moved.shares, numbers);
  return effect;
}

std::optional<double> share_of_system(const JudgedPoints& judged) {
  for (std::size_t i = 0; i < judged.points.size(); ++i) {
    const SweepPoint& point = *judged.points[i];
    if (std::none_of(point.begin(), point.end(), [](const auto& place) { return !!place; })) {
      return judged.shares[i];
    }
  }
  return {};
}

SweepJson unknown_json(const SystemSweep& sweep, std::size_t number) {
  const Unknown& unknown = sweep.sweep.unknowns[number];
  const UnknownParameters& given = unknown.parameters;
  SweepJson json = {{"name", unknown.name},
                    {"key", given.key},
                    {"text", given.text},
                    {"system", sweep.own_values[number]}};
  if (given.is_range()) {
    json.update({{"low", *given.low}, {"high", *given.high}, {"scale", choice_name(given.scale)}});
  }
  json["cells"] = SweepJson::array();
  for (const SweepCell& cell : sweep_cells(sweep.sweep, unknown)) {
    json["cells"].push_back({{"from", to_json_value(cell.from)}, {"to", to_json_value(cell.to)}});
  }
  return json;
}

SweepJson effect_json(const std::string& unknown, const UnknownEffect& effect) {
  SweepJson cells = SweepJson::array();
  for (const CellOutcome& cell : effect.cells) {
    const SweepJson share = cell.points > 0 ? SweepJson(cell.share) : SweepJson(nullptr);
    cells.push_back({{"points", cell.points}, {"share", share}});
  }
  const auto order = [&](double FirstOrder::* figure) {
    return effect.order ? SweepJson(*effect.order.*figure) : SweepJson(nullptr);
  };
  return {{"name", unknown},
          {"cells", std::move(cells)},
          {"change", effect.change},
          {"first_order", order(&FirstOrder::index)},
          {"first_order_by_chance", order(&FirstOrder::by_chance)}};
}

SweepJson sweep_claim_json(const SweepResults& results, std::size_t number) {
  const Claim& claim = results.sweep.claims[number];
  const ClaimEffects over = effects_on(results, number);
  SweepJson json = detail::claim_json(claim);
  json["points"] = over.points;
  json["holds"] = over.holds;
  json["mean_share"] = over.mean_share;
  json["unknowns"] = SweepJson::array();
  for (std::size_t i = 0; i < over.effects.size(); ++i) {
    json["unknowns"].push_back(effect_json(results.sweep.sweep.unknowns[i].name, over.effects[i]));
  }
  return json;
}

SweepJson point_outcome_json(const ClaimOutcome& outcome) {
  const auto& chance = outcome.chance_share;
  return {{"share", outcome.share()},
          {"chance_share", chance ? SweepJson(*chance) : SweepJson(nullptr)},
          {"values", outcome.values}};
}

SweepJson point_json(const SweepDescription& sweep, const SweepPointResults& point) {
  SweepJson values = SweepJson::object();
  for (std::size_t i = 0; i < point.point.size(); ++i) {
    const auto& place = point.point[i];
    values[sweep.unknowns[i].name] = place ? to_json_value(place->value) : SweepJson(nullptr);
  }
  SweepJson claims = SweepJson::array();
  for (const auto& outcome : point.claims) {
    claims.push_back(outcome ? point_outcome_json(*outcome) : SweepJson(nullptr));
  }
  return {{"values", std::move(values)},
          {"recordings", point.recordings},
          {"claims", std::move(claims)}};
}

// Nothing if it cannot be judged.
std::optional<ClaimOutcome> outcome_of(const Claim& claim, const std::vector<PartResults>& parts) {
  std::vector<ClaimOutcome> outcome = judge(std::vector<Claim>{claim}, parts);
  if (outcome.empty() || !outcome.front().undecidable.empty()) return {};
  return std::move(outcome.front());
}

}  // namespace

SweepPointResults judge_point(const SystemSweep& sweep, const SweepPoint& point,
                              const std::vector<PartResults>& parts) {
  SweepPointResults results{point, {}, {}, {}};
  for (const PartResults& part : parts) {
    for (const RecordingInfo& one : part.recordings) {
      if (!contains(results.recordings, one.name)) results.recordings.push_back(one.name);
    }
  }
  for (const Claim& claim : sweep.claims) results.claims.push_back(outcome_of(claim, parts));
  for (const Claim& measure : sweep.measured)
    results.measured.push_back(outcome_of(measure, parts));
  return results;
}

std::size_t SweepPointResults::pairs() const {
  std::size_t pairs = 0;
  for (const auto* outcomes : {&claims, &measured}) {
    for (const auto& outcome : *outcomes) {
      pairs = std::max(pairs, outcome ? outcome->values.size() : 0);
    }
  }
  return pairs;
}

std::vector<std::size_t> ClaimEffects::by_effect() const {
  std::vector<std::size_t> numbers(effects.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto size = [&](std::size_t i) {
    return effects[i].order ? effects[i].order->index : effects[i].change;
  };
  std::sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(-size(a), a) < std::pair(-size(b), b);
  });
  return numbers;
}

ClaimEffects effects_on(const SweepResults& results, std::size_t claim) {
  const JudgedPoints judged = judged_points(results, claim);
  const auto holding = std::count_if(judged.shares.begin(), judged.shares.end(),
                                     [](double share) { return reaches(share, kHoldsFrom); });
  ClaimEffects over;
  over.points = judged.shares.size();
  if (over.points > 0) over.holds = static_cast<double>(holding) / static_cast<double>(over.points);
  over.mean_share = judged.mean();
  over.system_share = share_of_system(judged);
  for (std::size_t i = 0; i < results.sweep.sweep.unknowns.size(); ++i) {
    over.effects.push_back(effect_of(results, judged, i, over.system_share));
  }
  return over;
}

std::string to_json(const SweepResults& results) {
  const SweepDescription& sweep = results.sweep.sweep;
  SweepJson unknowns = SweepJson::array();
  for (std::size_t i = 0; i < sweep.unknowns.size(); ++i) {
    unknowns.push_back(unknown_json(results.sweep, i));
  }
  SweepJson claims = SweepJson::array();
  for (std::size_t i = 0; i < results.sweep.claims.size(); ++i) {
    claims.push_back(sweep_claim_json(results, i));
  }
  SweepJson points = SweepJson::array();
  for (const SweepPointResults& point : results.points) points.push_back(point_json(sweep, point));
  const SweepJson json = {{"version", kSweepVersion},
                          {"system", names_of(results.sweep)},
                          {"design", choice_name(sweep.sweep.design)},
                          {"seed", sweep.sweep.seed},
                          {"pairs", sweep.sweep.pairs},
                          {"unknowns", std::move(unknowns)},
                          {"claims", std::move(claims)},
                          {"not_judged", results.sweep.not_judged},
                          {"points", std::move(points)}};
  return json.dump(-1, ' ', false, SweepJson::error_handler_t::replace) + "\n";
}

}  // namespace somato
