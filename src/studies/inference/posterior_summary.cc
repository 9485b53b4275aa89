#include "studies/inference/posterior_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

double weighted_mean(std::span<const double> values, std::span<const double> weights) {
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += weights[i] * values[i];
    all += weights[i];
  }
  return sum / all;
}

// Both have the same size; weights have a sum above 0.
PlaceSummary summarize(std::span<const double> values, std::span<const double> weights) {
  PlaceSummary summary;
  summary.mean = weighted_mean(values, weights);
  std::vector<double> squares;
  for (const double value : values)
    squares.push_back((value - summary.mean) * (value - summary.mean));
  summary.deviation = std::sqrt(weighted_mean(squares, weights));
  summary.low = weighted_quantile(values, weights, 0.05);
  summary.median = weighted_quantile(values, weights, 0.5);
  summary.high = weighted_quantile(values, weights, 0.95);
  return summary;
}

}  // namespace

double weighted_quantile(std::span<const double> values, std::span<const double> weights,
                         double share) {
  require(!values.empty() && values.size() == weights.size(),
          "a quantile requires values with weights");
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(values[a], a) < std::pair(values[b], b);
  });
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0;
  for (const std::size_t i : order) {
    sum += weights[i];
    if (sum >= share * all) return values[i];
  }
  return values[order.back()];  // rounding
}

double weighted_rank(std::span<const double> values, std::span<const double> weights, double value,
                     double of_equal) {
  double below = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    all += weights[i];
    if (values[i] < value) below += weights[i];
    if (values[i] == value) below += of_equal * weights[i];
  }
  return below / all;
}

PlaceSummary summary_of(const Posterior& posterior, std::size_t unknown) {
  return summarize(places_of(posterior.places, unknown), posterior.weights);
}

PlaceSummary prior_summary_of(const Simulations& simulations, std::size_t unknown) {
  const std::vector<double> equal(simulations.places.rows(), 1.0);
  return summarize(places_of(simulations.places, unknown), equal);
}

Matrix<double> correlations_of(const Posterior& posterior) {
  const std::size_t unknowns = posterior.places.columns();
  Matrix<double> correlations(unknowns, unknowns);
  std::vector<PlaceSummary> summaries;
  summaries.reserve(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u) summaries.push_back(summary_of(posterior, u));
  for (std::size_t a = 0; a < unknowns; ++a) {
    for (std::size_t b = 0; b < unknowns; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < posterior.size(); ++i) {
        sum += posterior.weights[i] * (posterior.places(i, a) - summaries[a].mean) *
               (posterior.places(i, b) - summaries[b].mean);
      }
      const double scale = summaries[a].deviation * summaries[b].deviation;
      correlations(a, b) = scale > 0.0 ? sum / scale : 0.0;
    }
  }
  return correlations;
}

}  // namespace somato
