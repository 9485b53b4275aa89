#include "somato/maps/novelty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/core/elementary.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kRounding = 1e-9;  // of rate (n + 1), which is often a whole number

tl::unexpected<Error> no_distances() {
  return fail(ErrorKind::kData, "the explorations have no distance from the neurons of the map", {},
              "'unknown' needs explorations that differ from each other");
}

tl::unexpected<Error> no_repeated_class() {
  return fail(ErrorKind::kData,
              "no class has two explorations whose distance shows how much a class spreads", {},
              "'unknown' needs classes of at least two explorations in each part of the training; "
              "use more explorations, or more 'calibration_folds'");
}

std::size_t scores_above(std::size_t samples, double rate) {
  return static_cast<std::size_t>(std::floor(rate * static_cast<double>(samples + 1) + kRounding));
}

// The probability that a beta variable with the parameters `above` and samples + 1 - above, which
// are whole numbers, is at most `share`: that of `above` or more successes in `samples` trials.
double beta_below(std::size_t above, std::size_t samples, double share) {
  if (share <= 0.0 || share >= 1.0) return share <= 0.0 ? 0.0 : 1.0;
  const double odds = natural_log(share) - natural_log(1.0 - share);
  double term = static_cast<double>(samples) * natural_log(1.0 - share);  // a logarithm
  double fewer = 0.0;
  for (std::size_t successes = 0; successes < above; ++successes) {
    fewer += exponential(term);
    const auto failures = static_cast<double>(samples - successes);
    term += natural_log(failures / static_cast<double>(successes + 1)) + odds;
  }
  return 1.0 - fewer;
}

double beta_quantile(std::size_t above, std::size_t samples, double probability) {
  constexpr int kHalvings = 50;
  double low = 0.0;
  double high = 1.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (low + high);
    (beta_below(above, samples, middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

void Novelty::add_classes(std::size_t count) {
  require(!scales.empty(), "a threshold has a scale for each class");
  const double mean =
      std::accumulate(scales.begin(), scales.end(), 0.0) / static_cast<double>(scales.size());
  scales.resize(std::max(count, scales.size()), mean);
}

Result<std::vector<double>> class_scales(const std::vector<std::size_t>& classes,
                                         const std::vector<double>& distances, std::size_t count) {
  require(!classes.empty() && classes.size() == distances.size(),
          "scales of classes need a distance for each sample");
  std::vector<double> sums(count, 0.0);
  std::vector<double> samples(count, 0.0);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    require(classes[i] < count, "a sample has an unknown class");
    sums[classes[i]] += distances[i];
    samples[classes[i]] += 1.0;
  }
  double sum = 0.0;
  double repeated = 0.0;
  for (std::size_t label = 0; label < count; ++label) {
    if (samples[label] < 2.0) sums[label] = samples[label] = 0.0;
    sum += sums[label];
    repeated += samples[label];
  }
  if (repeated == 0.0) return no_repeated_class();
  if (!(sum > 0.0)) return no_distances();
  for (std::size_t label = 0; label < count; ++label) {
    sums[label] = (sums[label] + sum / repeated) / (samples[label] + 1.0);
  }
  return sums;
}

Result<void> check_scores(std::size_t count, double rate) {
  require(rate > 0.0 && rate < 1.0, "a false-alarm rate is above 0 and below 1");
  const double wanted = std::max(2.0, std::ceil(1.0 / rate - kRounding) - 1.0);
  if (static_cast<double>(count) >= wanted) return {};
  return fail(
      ErrorKind::kData,
      fmt::format("a threshold with a false-alarm rate of {} cannot be found from {} training "
                  "exploration{}",
                  rate, count, count == 1 ? "" : "s"),
      {}, fmt::format("use at least {:.0f} explorations, or a higher false_alarm_rate", wanted));
}

FalseAlarmInterval false_alarm_interval(std::size_t samples, double rate) {
  require(check_scores(samples, rate).has_value(), "too few scores for a threshold");
  const std::size_t above = scores_above(samples, rate);
  return {beta_quantile(above, samples, 0.025), beta_quantile(above, samples, 0.975)};
}

Result<double> conformal_threshold(std::vector<double> scores, double rate) {
  const std::size_t count = scores.size();
  SOMATO_TRY_VOID(check_scores(count, rate));
  const std::size_t above = scores_above(count, rate);
  const auto place = scores.begin() + static_cast<std::ptrdiff_t>(count - above);
  std::nth_element(scores.begin(), place, scores.end());
  if (!(*place > 0.0)) return no_distances();
  return *place;
}

}  // namespace somato
