#include "studies/inference/inference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "somato/core/random.h"
#include "studies/sweep/sweep_points.h"

namespace somato {
namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

double value_of_pair(const std::optional<ClaimOutcome>& outcome, std::size_t pair) {
  return outcome && pair < outcome->values.size() ? outcome->values[pair] : kNotMeasured;
}

double number_of(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.content))
    return static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&value.content);
  return number ? *number : kNotMeasured;
}

// An integer, as a value of a list, is at the middle of its part.
double place_in_prior(const SweepDescription& sweep, const Unknown& unknown,
                      const SweepPlace& place) {
  UnknownParameters given = unknown.parameters;
  if (!given.is_range()) {
    return (static_cast<double>(place.cell) + 0.5) /
           static_cast<double>(sweep_cells(sweep, unknown).size());
  }
  double number = number_of(place.value);
  if (given.whole) {
    *given.high += 1.0;
    number += 0.5;
  }
  return place_in_range(given, number).value_or(kNotMeasured);
}

void add_simulation(const std::vector<double>& places, const SweepPointResults& point,
                    std::size_t pair, Simulations& all) {
  std::copy(places.begin(), places.end(), all.places.add_row().begin());
  const auto row = all.statistics.add_row();
  for (std::size_t t = 0; t < row.size(); ++t) row[t] = value_of_pair(point.measured[t], pair);
}

std::size_t cell_at(double place, std::size_t cells) {
  return std::min(static_cast<std::size_t>(place * static_cast<double>(cells)), cells - 1);
}

std::vector<double> shares_of_cells(const SweepDescription& sweep, const Unknown& unknown,
                                    const std::vector<double>& places,
                                    const std::vector<double>& weights) {
  std::vector<double> shares(sweep_cells(sweep, unknown).size(), 0.0);
  double all = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    shares[cell_at(places[i], shares.size())] += weights[i];
    all += weights[i];
  }
  for (double& share : shares) share /= all;
  return shares;
}

InferredUnknown inferred(const SweepDescription& sweep, std::size_t number, const Simulations& all,
                         const Posterior& posterior) {
  const Unknown& unknown = sweep.unknowns[number];
  const std::vector<double> equal(all.draw.size(), 1.0);
  return {prior_summary_of(all, number), summary_of(posterior, number),
          shares_of_cells(sweep, unknown, places_of(all.places, number), equal),
          shares_of_cells(sweep, unknown, places_of(posterior.places, number), posterior.weights)};
}

std::vector<double> predicted_values(const Simulations& all, const Posterior& posterior) {
  std::vector<double> means(all.statistics.columns(), 0.0);
  for (std::size_t i = 0; i < posterior.size(); ++i) {
    const auto values = all.statistics.row(posterior.simulations[i]);
    for (std::size_t t = 0; t < means.size(); ++t) means[t] += posterior.weights[i] * values[t];
  }
  return means;
}

tl::unexpected<Error> nothing_measured(const Simulations& all, const Targets& targets) {
  for (std::size_t t = 0; t < targets.targets.size(); ++t) {
    const std::vector<double> values = places_of(all.statistics, t);
    if (std::any_of(values.begin(), values.end(),
                    [](double value) { return std::isfinite(value); }))
      continue;
    return fail(ErrorKind::kData,
                "no simulation has the measure of the target '" + targets.targets[t].text + "'",
                targets.targets[t].where, "use a metric that the protocol of the system gives");
  }
  return fail(ErrorKind::kData, "no simulation has the measures of all targets",
              targets.targets.front().where,
              "remove targets that are measured at other points than the others");
}

}  // namespace

double InferredUnknown::shrinkage() const {
  return prior.deviation > 0.0 ? posterior.deviation / prior.deviation : 1.0;
}

Simulations simulations_of(const SweepResults& results) {
  const SweepDescription& sweep = results.sweep.sweep;
  Simulations all{Matrix<double>(0, sweep.unknowns.size()),
                  Matrix<double>(0, results.sweep.measured.size()),
                  {},
                  continuous_unknowns(sweep),
                  {}};
  for (std::size_t draw = 0; draw < results.points.size(); ++draw) {
    const SweepPointResults& point = results.points[draw];
    const std::vector<double> places = places_in_prior(sweep, point.point);
    for (std::size_t pair = 0; pair < point.pairs(); ++pair) {
      add_simulation(places, point, pair, all);
      all.draw.push_back(draw);
    }
  }
  return all;
}

Result<Inference> infer(const SweepResults& results, const Targets& targets) {
  Simulations all = simulations_of(results);
  auto posterior = accept_nearest(all, targets.observation(), targets.rule());
  if (!posterior) return nothing_measured(all, targets);
  return summarized(results.sweep.sweep, std::move(all), std::move(*posterior),
                    targets.observation().scales, targets.rule(), targets.inference);
}

std::vector<double> places_in_prior(const SweepDescription& sweep, const SweepPoint& point) {
  std::vector<double> places;
  places.reserve(point.size());
  for (std::size_t u = 0; u < point.size(); ++u) {
    places.push_back(place_in_prior(sweep, sweep.unknowns[u], *point[u]));
  }
  return places;
}

std::vector<bool> continuous_unknowns(const SweepDescription& sweep) {
  std::vector<bool> are;
  are.reserve(sweep.unknowns.size());
  for (const Unknown& unknown : sweep.unknowns) {
    are.push_back(unknown.parameters.is_range() && !unknown.parameters.whole);
  }
  return are;
}

Inference summarized(const SweepDescription& sweep, Simulations simulations, Posterior posterior,
                     const std::vector<double>& scales, const AcceptanceRule& rule,
                     const InferenceParameters& parameters) {
  Inference found;
  found.simulations = std::move(simulations);
  found.posterior = std::move(posterior);
  for (std::size_t u = 0; u < sweep.unknowns.size(); ++u) {
    found.unknowns.push_back(inferred(sweep, u, found.simulations, found.posterior));
  }
  found.correlations = correlations_of(found.posterior);
  found.calibration =
      calibrate(found.simulations, scales, rule, parameters.truths, parameters.seed);
  found.predicted = predicted_values(found.simulations, found.posterior);
  return found;
}

Value value_at_place(const SweepDescription& sweep, std::size_t unknown, double place) {
  return place_at(sweep, sweep.unknowns[unknown], place).value;
}

std::vector<SweepPoint> posterior_points(const SweepDescription& sweep, const Posterior& posterior,
                                         std::size_t bodies, std::uint64_t seed) {
  std::vector<SweepPoint> points;
  const double begin = Random(seed, Stream::kDraws).uniform();
  std::size_t accepted = 0;
  double sum = posterior.weights.front();
  for (std::size_t body = 0; body < bodies; ++body) {
    const double at = (static_cast<double>(body) + begin) / static_cast<double>(bodies);
    while (sum <= at && accepted + 1 < posterior.size()) sum += posterior.weights[++accepted];
    const auto places = posterior.places.row(accepted);
    points.push_back(point_at(sweep, {places.begin(), places.end()}));
  }
  return points;
}

}  // namespace somato
