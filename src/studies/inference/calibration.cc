#include "studies/inference/calibration.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/core/elementary.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "studies/inference/posterior_summary.h"

namespace somato {
namespace {

constexpr double kOutside = 0.05;  // on each side of a central 90 % interval

bool is_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value); });
}

// One simulation of each of `count` different draws.
std::vector<std::size_t> selected_truths(const Simulations& all, std::size_t count,
                                         Random& random) {
  std::set<std::size_t> draws;
  std::vector<std::size_t> selected;
  for (const std::size_t i : random_order(all.draw.size(), random)) {
    if (selected.size() == count) break;
    if (is_finite(all.statistics.row(i)) && draws.insert(all.draw[i]).second) selected.push_back(i);
  }
  return selected;
}

Observation observation_of(const Simulations& all, std::size_t truth,
                           const std::vector<double>& scales) {
  const auto values = all.statistics.row(truth);
  return {{values.begin(), values.end()}, scales};
}

double deviation_from_uniform(std::vector<double> ranks) {
  std::sort(ranks.begin(), ranks.end());
  const auto count = static_cast<double>(ranks.size());
  double greatest = 0.0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    greatest = std::max({greatest, static_cast<double>(i + 1) / count - ranks[i],
                         ranks[i] - static_cast<double>(i) / count});
  }
  return greatest;
}

void summarize_ranks(Calibration& calibration) {
  for (std::size_t u = 0; u < calibration.ranks.columns(); ++u) {
    const std::vector<double> ranks = places_of(calibration.ranks, u);
    const auto inside = std::count_if(ranks.begin(), ranks.end(), [](double rank) {
      return rank >= kOutside && rank <= 1.0 - kOutside;
    });
    calibration.covered.push_back(static_cast<double>(inside) / static_cast<double>(ranks.size()));
    calibration.uniform_p.push_back(kolmogorov_p(deviation_from_uniform(ranks), ranks.size()));
  }
}

}  // namespace

double kolmogorov_p(double difference, std::size_t count) {
  const double root = std::sqrt(static_cast<double>(count));
  const double scaled = (root + 0.12 + 0.11 / root) * difference;
  if (scaled < 0.2)
    return 1.0;  // the series needs many terms there, and the probability is above 1 - 1e-12
  double p = 0.0;
  for (int k = 1; k <= 100; ++k) {
    const double term = 2.0 * exponential(-2.0 * k * k * scaled * scaled);
    p += k % 2 == 1 ? term : -term;
  }
  return std::clamp(p, 0.0, 1.0);
}

Calibration calibrate(const Simulations& simulations, const std::vector<double>& scales,
                      const AcceptanceRule& rule, std::size_t truths, std::uint64_t seed) {
  Random random(seed, Stream::kDesign);
  Calibration calibration;
  const std::vector<std::size_t> selected = selected_truths(simulations, truths, random);
  std::vector<double> ranks;
  std::vector<double> squares(simulations.places.columns(), 0.0);
  std::size_t inferred = 0;
  for (const std::size_t truth : selected) {
    const auto posterior = accept_nearest(simulations, observation_of(simulations, truth, scales),
                                          rule, simulations.group_of(truth));
    if (!posterior) continue;  // a single draw has statistics
    ++inferred;
    for (std::size_t u = 0; u < simulations.places.columns(); ++u) {
      ranks.push_back(weighted_rank(places_of(posterior->places, u), posterior->weights,
                                    simulations.places(truth, u), random.uniform()));
      const double error = summary_of(*posterior, u).mean - simulations.places(truth, u);
      squares[u] += error * error;
    }
  }
  calibration.ranks = Matrix<double>(inferred, simulations.places.columns(), std::move(ranks));
  if (inferred == 0) return calibration;
  summarize_ranks(calibration);
  for (const double sum : squares)
    calibration.errors.push_back(std::sqrt(sum / static_cast<double>(inferred)));
  return calibration;
}

}  // namespace somato
