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
  const double mean = std::accumulate(distances.begin(), distances.end(), 0.0) /
                      static_cast<double>(distances.size());
  if (!(mean > 0.0)) return no_distances();
  std::vector<double> sums(count, mean);
  std::vector<double> samples(count, 1.0);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    require(classes[i] < count, "a sample has an unknown class");
    sums[classes[i]] += distances[i];
    samples[classes[i]] += 1.0;
  }
  for (std::size_t label = 0; label < count; ++label) sums[label] /= samples[label];
  return sums;
}

Result<double> conformal_threshold(std::vector<double> scores, double rate) {
  require(rate > 0.0 && rate < 1.0, "a false-alarm rate is above 0 and below 1");
  const std::size_t count = scores.size();
  const auto above =
      static_cast<std::size_t>(std::floor(rate * static_cast<double>(count + 1) + kRounding));
  if (above == 0) {
    return fail(ErrorKind::kData,
                fmt::format("{} training explorations do not define a threshold with a false-alarm "
                            "rate of {}",
                            count, rate),
                {},
                fmt::format("use at least {:.0f} explorations, or a higher false_alarm_rate",
                            std::ceil(1.0 / rate - kRounding) - 1.0));
  }
  const auto place = scores.begin() + static_cast<std::ptrdiff_t>(count - above);
  std::nth_element(scores.begin(), place, scores.end());
  if (!(*place > 0.0)) return no_distances();
  return *place;
}

}  // namespace somato
