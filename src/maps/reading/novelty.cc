#include "somato/maps/novelty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

Result<double> conformal_threshold(std::vector<double> scores, double rate) {
  const std::size_t count = scores.size();
  SOMATO_TRY_VOID(check_scores(count, rate));
  const auto above =
      static_cast<std::size_t>(std::floor(rate * static_cast<double>(count + 1) + kRounding));
  const auto place = scores.begin() + static_cast<std::ptrdiff_t>(count - above);
  std::nth_element(scores.begin(), place, scores.end());
  if (!(*place > 0.0)) return no_distances();
  return *place;
}

}  // namespace somato
