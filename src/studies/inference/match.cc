#include "studies/inference/match.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "studies/inference/match_predictors.h"
#include "systems/signals/mean_and_spread.h"

namespace somato {
namespace {

constexpr double kMostLacking = 0.1;  // share of the draws

std::vector<std::size_t> all_rows(const TouchFeatures& touch) {
  std::vector<std::size_t> rows(touch.features.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::size_t lacking_draws(const MatchDraws& draws, std::size_t statistic) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < draws.statistics.rows(); ++i)
    count += std::isfinite(draws.statistics(i, statistic)) ? 0 : 1;
  return count;
}

std::string why_left_out(const MatchedTouch& touch, const MatchDraws& draws,
                         std::size_t statistic) {
  if (!std::isfinite(touch.fitted[statistic])) return "it cannot be measured in the recording";
  if (!std::isfinite(touch.scales[statistic]))
    return "its scale cannot be measured, because too few explorations have it";
  if (!(touch.scales[statistic] > 0.0))
    return "it has no scale, because the channel is constant in the recording";
  const std::size_t lacking = lacking_draws(draws, statistic);
  if (static_cast<double>(lacking) <= kMostLacking * static_cast<double>(draws.points.size()))
    return "";
  return fmt::format("{} of {} draws lack it", lacking, draws.points.size());
}

std::vector<std::size_t> used_statistics(const std::vector<std::string>& left_out) {
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < left_out.size(); ++k) {
    if (left_out[k].empty()) used.push_back(k);
  }
  return used;
}

std::vector<std::size_t> complete_draws(const MatchDraws& draws,
                                        const std::vector<std::size_t>& used) {
  std::vector<std::size_t> complete;
  for (std::size_t i = 0; i < draws.points.size(); ++i) {
    const bool has_all = std::all_of(used.begin(), used.end(), [&](std::size_t k) {
      return std::isfinite(draws.statistics(i, k));
    });
    if (has_all) complete.push_back(i);
  }
  return complete;
}

// The used statistics of the complete draws.
Matrix<double> statistics_of_draws(const MatchDraws& draws,
                                   const std::vector<std::size_t>& complete,
                                   const std::vector<std::size_t>& used) {
  Matrix<double> statistics(complete.size(), used.size());
  for (std::size_t i = 0; i < complete.size(); ++i) {
    for (std::size_t c = 0; c < used.size(); ++c)
      statistics(i, c) = draws.statistics(complete[i], used[c]);
  }
  return statistics;
}

std::vector<double> selected(std::span<const double> values,
                             const std::vector<std::size_t>& indices) {
  std::vector<double> some;
  some.reserve(indices.size());
  for (const std::size_t index : indices) some.push_back(values[index]);
  return some;
}

MatchPredictors selected(const MatchPredictors& all, const std::vector<std::size_t>& columns) {
  MatchPredictors some{Matrix<double>(0, columns.size()), selected(all.observed, columns)};
  for (std::size_t i = 0; i < all.of_draws.rows(); ++i)
    std::ranges::copy(selected(all.of_draws.row(i), columns), some.of_draws.add_row().begin());
  return some;
}

// Numbers of what draws share; nothing if all share the same, or nothing.
std::vector<std::size_t> groups_of(const MatchDraws& draws,
                                   const std::vector<std::size_t>& complete) {
  std::vector<std::size_t> groups;
  if (draws.movements.empty()) return groups;
  for (const std::size_t draw : complete) groups.push_back(draws.movements[draw]);
  const bool differ = std::ranges::adjacent_find(groups, std::not_equal_to{}) != groups.end();
  return differ ? groups : std::vector<std::size_t>{};
}

Matrix<double> places_of_draws(const MatchDraws& draws, const std::vector<std::size_t>& complete) {
  const SweepDescription& sweep = draws.sweep.sweep;
  Matrix<double> places(0, sweep.unknowns.size());
  for (const std::size_t draw : complete)
    std::ranges::copy(places_in_prior(sweep, draws.points[draw]), places.add_row().begin());
  return places;
}

// Predictions that are always right, as those of one place, count as exact within rounding.
Observation observation_of(const std::vector<RidgePrediction>& summaries) {
  Observation observed;
  for (const RidgePrediction& summary : summaries) {
    observed.values.push_back(summary.of_given);
    observed.scales.push_back(std::max(summary.error, 1e-9));
  }
  return observed;
}

Simulations simulations_with(Matrix<double> places, const std::vector<RidgePrediction>& summaries,
                             std::vector<bool> is_continuous, std::vector<std::size_t> groups) {
  Simulations all{std::move(places), {}, {}, std::move(is_continuous), std::move(groups)};
  all.statistics = Matrix<double>(all.places.rows(), summaries.size());
  for (std::size_t i = 0; i < all.places.rows(); ++i) {
    for (std::size_t u = 0; u < summaries.size(); ++u)
      all.statistics(i, u) = summaries[u].of_rows[i];
    all.draw.push_back(i);
  }
  return all;
}

Result<void> check_usable(const Match& match, const std::vector<std::size_t>& used,
                          const std::vector<std::size_t>& complete) {
  if (used.empty()) {
    return fail(ErrorKind::kData,
                "no statistic of the recording can be compared; of the first, " +
                    match.touch.names.front().measure + ", " + match.left_out.front(),
                {}, "use a recording with channels that vary, and several explorations");
  }
  if (complete.size() >= 3) return {};
  return fail(
      ErrorKind::kData,
      fmt::format("{} of {} draws have all statistics", complete.size(), match.draws.points.size()),
      {}, "increase 'points' of [sweep]");
}

// Without those that no draw reaches, which no setting explains; all of them if none is reached.
std::vector<std::size_t> reached_statistics(const Match& match,
                                            const std::vector<std::size_t>& used) {
  std::vector<std::size_t> reached;
  for (const std::size_t k : used) {
    if (!match.out_of_reach[k]) reached.push_back(k);
  }
  return reached.empty() ? used : reached;
}

void mark_unreached(Match& match, const std::vector<std::size_t>& used,
                    const Matrix<double>& statistics) {
  for (std::size_t c = 0; c < used.size(); ++c) {
    const std::vector<double> values = places_of(statistics, c);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const double observed = match.touch.fitted[used[c]];
    match.out_of_reach[used[c]] = observed < *least || observed > *greatest;
  }
}

// The reached statistics that the unknowns change.
MatchPredictors informative_predictors(Match& match, const std::vector<std::size_t>& reached,
                                       const std::vector<std::size_t>& complete,
                                       const Matrix<double>& places,
                                       std::span<const std::size_t> groups) {
  const MatchPredictors all = places_among_draws(
      statistics_of_draws(match.draws, complete, reached), selected(match.touch.fitted, reached));
  const std::vector<double> shares = explained_shares(all.of_draws, places, groups);
  std::vector<std::size_t> informative;
  for (std::size_t c = 0; c < reached.size(); ++c) {
    match.explained[reached[c]] = shares[c];
    if (shares[c] >= kLeastExplained) informative.push_back(c);
  }
  return selected(all, informative);
}

// A regression on many statistics may predict a place beyond all draws.
void keep_within_draws(Match& match) {
  for (std::size_t u = 0; u < match.summaries.size(); ++u) {
    RidgePrediction& summary = match.summaries[u];
    if (is_outside(summary)) match.outside.push_back(match.draws.sweep.sweep.unknowns[u].name);
    const auto [least, greatest] =
        std::minmax_element(summary.of_rows.begin(), summary.of_rows.end());
    summary.of_given = std::clamp(summary.of_given, *least, *greatest);
  }
}

double sum_of_squares(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

// Whether the adjustment brings the posteriors of held-out draws nearer to the truth.
bool adjustment_helps(const Match& match, const Simulations& all, const Observation& observation) {
  const InferenceParameters& parameters = match.parameters;
  const auto errors_with = [&](bool adjusted) {
    const AcceptanceRule rule{parameters.accepted, adjusted, true};
    return sum_of_squares(
        calibrate(all, observation.scales, rule, parameters.truths, parameters.seed).errors);
  };
  return errors_with(true) <= errors_with(false);
}

// Why settings are not adjusted although they are to be, or nothing.
std::string why_not_adjusted(const Match& match, const Simulations& all,
                             const Observation& observation) {
  if (!match.parameters.adjusted) return "";
  if (!match.outside.empty()) {
    return fmt::format("the recording is beyond all draws in what predicts {}",
                       fmt::join(match.outside, ", "));
  }
  if (adjustment_helps(match, all, observation)) return "";
  return "it would make the settings of draws that were held out less accurate";
}

void infer_unknowns(Match& match, const std::vector<std::size_t>& used,
                    const std::vector<std::size_t>& complete) {
  const SweepDescription& sweep = match.draws.sweep.sweep;
  mark_unreached(match, used, statistics_of_draws(match.draws, complete, used));
  Matrix<double> places = places_of_draws(match.draws, complete);
  const std::vector<std::size_t> groups = groups_of(match.draws, complete);
  const MatchPredictors predictors =
      informative_predictors(match, reached_statistics(match, used), complete, places, groups);
  match.summaries = predicted_places(predictors, places, groups);
  keep_within_draws(match);
  const Observation observation = observation_of(match.summaries);
  Simulations all =
      simulations_with(std::move(places), match.summaries, continuous_unknowns(sweep), groups);
  match.not_adjusted = why_not_adjusted(match, all, observation);
  const AcceptanceRule rule{match.parameters.accepted,
                            match.parameters.adjusted && match.not_adjusted.empty(), true};
  Posterior posterior = *accept_nearest(all, observation, rule);
  match.inference = summarized(sweep, std::move(all), std::move(posterior), observation.scales,
                               rule, match.parameters);
}

}  // namespace

Result<MatchedTouch> matched_touch(const Recording& real, const Recording& simulated,
                                   const MatchParameters& parameters) {
  MatchedTouch touch;
  SOMATO_TRY(touch.compared, compared_touch(real, simulated, parameters));
  touch.names = statistic_names(touch.compared);
  SOMATO_TRY(const auto features, touch_features(touch.compared, real));
  const auto [first, second] = halves_of(features);
  if (first.size() < 2 || second.size() < 2) {
    return fail(ErrorKind::kData,
                fmt::format("the recording has {} explorations to fit and {} to check",
                            first.size(), second.size()),
                real.explorations.front().source,
                "explore each thing several times; the first half is fitted, and two explorations "
                "in each half are the least");
  }
  touch.fitted = statistics_of(touch.compared, features, first);
  touch.held_out = statistics_of(touch.compared, features, second);
  touch.scales = statistic_scales(touch.compared, features, first);
  touch.fitted_explorations = first.size();
  touch.held_out_explorations = second.size();
  return touch;
}

Result<std::vector<double>> simulated_statistics(const MatchedTouch& touch,
                                                 const Recording& simulated) {
  SOMATO_TRY(const auto features, touch_features(touch.compared, simulated));
  return statistics_of(touch.compared, features, all_rows(features));
}

Result<Match> match_touch(MatchedTouch touch, MatchDraws draws,
                          const InferenceParameters& parameters) {
  Match match;
  match.touch = std::move(touch);
  match.draws = std::move(draws);
  match.parameters = parameters;
  for (std::size_t k = 0; k < match.touch.names.size(); ++k)
    match.left_out.push_back(why_left_out(match.touch, match.draws, k));
  match.out_of_reach.assign(match.left_out.size(), false);
  match.explained.assign(match.left_out.size(), std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::size_t> used = used_statistics(match.left_out);
  const std::vector<std::size_t> complete = complete_draws(match.draws, used);
  SOMATO_TRY_VOID(check_usable(match, used, complete));
  infer_unknowns(match, used, complete);
  for (const std::size_t draw : complete)
    match.of_draws.push_back(distance_from_held_out(match, match.draws.statistics.row(draw)));
  match.by_chance = distance_from_held_out(match, match.touch.fitted);
  return match;
}

TouchDistance distance_from_held_out(const Match& match, std::span<const double> statistics) {
  std::vector<double> differences;
  double squares = 0.0;
  double within = 0.0;
  for (const std::size_t k : used_statistics(match.left_out)) {
    const double difference =
        std::abs(statistics[k] - match.touch.held_out[k]) / match.touch.scales[k];
    if (!std::isfinite(difference)) continue;
    differences.push_back(difference);
    squares += difference * difference;
    within += difference < 2.0 ? 1.0 : 0.0;
  }
  if (differences.empty()) return {std::nan(""), std::nan(""), std::nan("")};
  const auto count = static_cast<double>(differences.size());
  std::sort(differences.begin(), differences.end());
  const double above = differences[differences.size() / 2];
  const double below = differences[(differences.size() - 1) / 2];
  return {(below + above) / 2.0, std::sqrt(squares / count), within / count};
}

TouchDistance mean_distance(const Match& match, const Matrix<double>& statistics) {
  MeanAndSpread median;
  MeanAndSpread root;
  MeanAndSpread within;
  for (std::size_t i = 0; i < statistics.rows(); ++i) {
    const TouchDistance one = distance_from_held_out(match, statistics.row(i));
    median.add(one.median);
    root.add(one.root_mean_square);
    within.add(one.within_two);
  }
  return {median.mean(), root.mean(), within.mean()};
}

}  // namespace somato
