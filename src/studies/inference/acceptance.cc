#include "studies/inference/acceptance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "base/core/elementary.h"
#include "somato/core/check.h"
#include "studies/inference/local_regression.h"

namespace somato {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void check_sizes(const Simulations& all, const Observation& observed, const AcceptanceRule& rule) {
  const std::size_t count = all.places.rows();
  require(all.statistics.rows() == count && all.draw.size() == count,
          "each simulation has places, statistics and a draw");
  require(all.is_continuous.size() == all.places.columns(), "each unknown is continuous or not");
  require(all.group.empty() || all.group.size() == count, "each simulation has a group, or none");
  require(!rule.predictions || all.statistics.columns() == all.places.columns(),
          "each unknown has a prediction");
  require(observed.values.size() == all.statistics.columns() &&
              observed.scales.size() == observed.values.size(),
          "each statistic has an observed value and a scale");
  require(std::all_of(observed.scales.begin(), observed.scales.end(),
                      [](double scale) { return scale > 0.0; }),
          "scales are above 0");
  require(rule.share > 0.0 && rule.share <= 1.0, "the accepted share is above 0 and at most 1");
}

struct DrawDistances {
  std::vector<double> of_simulation;  // infinite for those that cannot be accepted
  double last = 0.0;                  // of the last accepted one
  double end = kInfinite;             // the first one that is not accepted
};

DrawDistances distances_to(const Simulations& all, const Observation& observed, double share,
                           std::optional<std::size_t> left_out) {
  DrawDistances distances;
  for (std::size_t i = 0; i < all.draw.size(); ++i) {
    const bool may_be = all.group_of(i) != left_out;
    distances.of_simulation.push_back(may_be ? distance_of(all.statistics.row(i), observed)
                                             : kInfinite);
  }
  std::vector<double> sorted = distances.of_simulation;
  std::sort(sorted.begin(), sorted.end());
  const auto finite = std::lower_bound(sorted.begin(), sorted.end(), kInfinite) - sorted.begin();
  if (finite == 0) {
    distances.last = -1.0;
    return distances;
  }
  const std::vector<std::size_t>& groups = all.group.empty() ? all.draw : all.group;
  const auto candidates = static_cast<double>(
      groups.size() - static_cast<std::size_t>(std::count(groups.begin(), groups.end(), left_out)));
  const auto wanted = static_cast<std::ptrdiff_t>(std::ceil(share * candidates));
  distances.last =
      sorted[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(wanted, 1, finite) - 1)];
  const auto after = std::upper_bound(sorted.begin(), sorted.end(), distances.last);
  if (after != sorted.end()) distances.end = *after;
  return distances;
}

void set_weights(const DrawDistances& distances, Posterior& accepted) {
  double sum = 0.0;
  for (const std::size_t i : accepted.simulations) {
    const double part = distances.of_simulation[i] / distances.end;  // 0 if all are accepted
    accepted.weights.push_back(1.0 - part * part);
    sum += accepted.weights.back();
  }
  for (double& weight : accepted.weights) weight /= sum;
}

// Places at the ends of the range have finite odds: as far inside as half of one of this many equal
// parts.
double log_odds(double place, double parts) {
  const double inside = std::clamp(place, 0.5 / parts, 1.0 - 0.5 / parts);
  return natural_log(inside / (1.0 - inside));
}

double place_of(double odds) {
  return 1.0 / (1.0 + exponential(-odds));
}

Matrix<double> differences(const Simulations& all, const Observation& observed,
                           const Posterior& accepted) {
  Matrix<double> rows(accepted.size(), observed.values.size());
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    const auto values = all.statistics.row(accepted.simulations[i]);
    for (std::size_t j = 0; j < values.size(); ++j) {
      rows(i, j) = (values[j] - observed.values[j]) / observed.scales[j];
    }
  }
  return rows;
}

void adjust(const Simulations& all, const Observation& observed, Posterior& accepted) {
  const LocalRegression regression(differences(all, observed, accepted), accepted.weights);
  const auto parts = static_cast<double>(all.draw.size());
  for (std::size_t u = 0; u < all.is_continuous.size(); ++u) {
    if (!all.is_continuous[u]) continue;
    std::vector<double> odds = places_of(accepted.places, u);
    for (double& place : odds) place = log_odds(place, parts);
    regression.adjust(odds);
    for (std::size_t i = 0; i < accepted.size(); ++i) accepted.places(i, u) = place_of(odds[i]);
  }
}

void adjust_by_predictions(const Simulations& all, const Observation& observed,
                           Posterior& accepted) {
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    const auto predicted = all.statistics.row(accepted.simulations[i]);
    for (std::size_t u = 0; u < predicted.size(); ++u) {
      if (!all.is_continuous[u]) continue;
      const double place = accepted.places(i, u) - predicted[u] + observed.values[u];
      accepted.places(i, u) = std::clamp(place, 0.0, 1.0);
    }
  }
}

}  // namespace

std::vector<double> places_of(const Matrix<double>& places, std::size_t unknown) {
  std::vector<double> values;
  values.reserve(places.rows());
  for (std::size_t i = 0; i < places.rows(); ++i) values.push_back(places(i, unknown));
  return values;
}

double distance_of(std::span<const double> statistics, const Observation& observed) {
  double sum = 0.0;
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    const double difference = (statistics[i] - observed.values[i]) / observed.scales[i];
    sum += difference * difference;
  }
  const double distance =
      std::sqrt(sum / static_cast<double>(std::max<std::size_t>(statistics.size(), 1)));
  return std::isfinite(distance) ? distance : kInfinite;
}

std::optional<Posterior> accept_nearest(const Simulations& simulations, const Observation& observed,
                                        const AcceptanceRule& rule,
                                        std::optional<std::size_t> left_out) {
  check_sizes(simulations, observed, rule);
  const DrawDistances distances = distances_to(simulations, observed, rule.share, left_out);
  if (distances.last < 0.0) return {};
  Posterior accepted;
  for (std::size_t i = 0; i < simulations.draw.size(); ++i) {
    if (distances.of_simulation[i] <= distances.last) accepted.simulations.push_back(i);
  }
  set_weights(distances, accepted);
  accepted.places = Matrix<double>(accepted.size(), simulations.places.columns());
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    const auto places = simulations.places.row(accepted.simulations[i]);
    std::copy(places.begin(), places.end(), accepted.places.row(i).begin());
  }
  if (rule.predictions) {
    accepted.is_adjusted = rule.adjusted;
    if (rule.adjusted) adjust_by_predictions(simulations, observed, accepted);
    return accepted;
  }
  const std::size_t coefficients = observed.values.size() + 1;
  accepted.is_adjusted = rule.adjusted && accepted.size() >= kLeastOfCoefficient * coefficients;
  if (accepted.is_adjusted) adjust(simulations, observed, accepted);
  return accepted;
}

}  // namespace somato
