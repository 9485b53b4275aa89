#include "systems/signals/channel_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "systems/signals/mean_and_spread.h"
#include "systems/signals/real_transform.h"

namespace somato {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

bool is_valid(const Channel& channel, std::size_t frame, std::size_t element) {
  return channel.valid.empty() || channel.valid(frame, element) != 0;
}

// NaN for a missing value.
std::vector<double> series_of(const Channel& channel, std::size_t element) {
  std::vector<double> values;
  values.reserve(channel.frames.rows());
  for (std::size_t i = 0; i < channel.frames.rows(); ++i) {
    values.push_back(is_valid(channel, i, element) ? channel.frames(i, element) : kNoValue);
  }
  return values;
}

MeanAndSpread moments_of(std::span<const double> values) {
  MeanAndSpread moments;
  for (const double value : values) moments.add(value);
  return moments;
}

// Linear between the sorted values, as the default of NumPy.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return kNoValue;
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::size_t octaves_of(std::size_t frames) {
  std::size_t octaves = 0;
  for (std::size_t bin = 1; bin < frames / 2; bin *= 2) ++octaves;
  return octaves;
}

// Adds the mean squares of the octaves of each whole part of the series; missing values are at its
// mean. A shorter series is one part with zeros.
void add_octaves(std::span<const double> series, RealTransform& transform,
                 std::vector<MeanAndSpread>& octaves) {
  const std::size_t length = transform.length();
  std::vector<double> part(length);
  std::vector<double> squares(transform.bins());
  const std::size_t parts = std::max<std::size_t>(series.size() / length, 1);
  for (std::size_t p = 0; p < parts; ++p) {
    const auto values = series.subspan(p * length, std::min(length, series.size() - p * length));
    const double mean = moments_of(values).mean();
    std::fill(part.begin(), part.end(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isfinite(values[i])) part[i] = values[i] - mean;
    }
    transform.squares(part, squares);
    for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
      double sum = 0.0;
      const std::size_t first = std::size_t{1} << octave;
      for (std::size_t bin = first; bin < 2 * first; ++bin) sum += squares[bin];
      octaves[octave].add(2.0 * sum / static_cast<double>(length * length));
    }
  }
}

// The mean correlation of all pairs of series, of which a constant one correlates with none: the
// square of the sum of standardized series contains each pair twice.
double mean_correlation(const std::vector<std::vector<double>>& series,
                        const std::vector<MeanAndSpread>& moments) {
  const std::size_t frames = series.front().size();
  double pairs_twice = 0.0;
  for (std::size_t i = 0; i < frames; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t e = 0; e < series.size(); ++e) {
      const double deviation = moments[e].deviation();
      if (!(deviation > 0.0) || !std::isfinite(series[e][i])) continue;
      const double value = (series[e][i] - moments[e].mean()) / deviation;
      sum += value;
      squares += value * value;
    }
    pairs_twice += sum * sum - squares;
  }
  const auto count = static_cast<double>(series.size());
  return pairs_twice / static_cast<double>(frames) / (count * (count - 1.0));
}

// The root mean square of second differences, divided by the root of 6: the standard deviation of
// white noise on a course that is straight over three frames.
double roughness_of(const std::vector<std::vector<double>>& series) {
  MeanAndSpread squares;
  for (const std::vector<double>& one : series) {
    for (std::size_t i = 2; i < one.size(); ++i) {
      const double second = one[i] - 2.0 * one[i - 1] + one[i - 2];
      squares.add(second * second / 6.0);
    }
  }
  return std::sqrt(squares.mean());
}

double mean_of_part(const std::vector<std::vector<double>>& series, std::size_t part) {
  const std::size_t frames = series.front().size();
  MeanAndSpread moments;
  for (const std::vector<double>& one : series) {
    for (std::size_t i = part * frames / kLeastSeriesFrames;
         i < (part + 1) * frames / kLeastSeriesFrames; ++i)
      moments.add(one[i]);
  }
  return moments.mean();
}

bool has_single_elements(const FeaturedChannel& channel) {
  return channel.elements > 1 && channel.elements <= kMostSingleElements;
}

std::vector<double> spectrum_of(const FeaturedChannel& featured,
                                const std::vector<std::vector<double>>& series) {
  if (featured.spectrum_frames == 0) return {};
  RealTransform transform(featured.spectrum_frames);
  std::vector<MeanAndSpread> octaves(octaves_of(featured.spectrum_frames));
  for (const std::vector<double>& one : series) add_octaves(one, transform, octaves);
  std::vector<double> roots;
  roots.reserve(octaves.size());
  for (const MeanAndSpread& octave : octaves) roots.push_back(std::sqrt(octave.mean()));
  return roots;
}

}  // namespace

std::vector<std::string> channel_feature_names(const FeaturedChannel& channel) {
  // The spread of all values comes second: scales are measured by it.
  std::vector<std::string> names{"mean", "spread of all values"};
  if (has_single_elements(channel)) {
    for (std::size_t e = 0; e < channel.elements; ++e)
      names.push_back(fmt::format("mean of element {}", e + 1));
  }
  if (channel.elements > 1) names.emplace_back("spread between elements");
  if (channel.is_series || channel.elements > 1) {
    for (const char* name : {"quantile 0.05", "median", "quantile 0.95"}) names.emplace_back(name);
  }
  if (!channel.is_series) return names;
  names.emplace_back("spread within explorations");
  names.emplace_back("roughness over three frames");
  if (has_single_elements(channel)) {
    for (std::size_t e = 0; e < channel.elements; ++e)
      names.push_back(fmt::format("spread of element {} within explorations", e + 1));
  }
  for (std::size_t p = 0; p < kLeastSeriesFrames; ++p)
    names.push_back(fmt::format("mean of quarter {}", p + 1));
  if (channel.elements > 1) names.emplace_back("correlation of elements");
  for (std::size_t o = 0; o < octaves_of(channel.spectrum_frames); ++o)
    names.push_back(fmt::format("spectrum, octave {}", o + 1));
  return names;
}

std::vector<double> channel_features(const FeaturedChannel& featured, const Channel& channel) {
  std::vector<std::vector<double>> series;
  std::vector<MeanAndSpread> moments;
  std::vector<double> sorted;
  MeanAndSpread levels;
  MeanAndSpread variances;
  for (std::size_t e = 0; e < featured.elements; ++e) {
    series.push_back(series_of(channel, e));
    moments.push_back(moments_of(series.back()));
    levels.add(moments.back().mean());
    variances.add(moments.back().variance());
    std::copy_if(series.back().begin(), series.back().end(), std::back_inserter(sorted),
                 [](double value) { return std::isfinite(value); });
  }
  std::vector<double> features{moments_of(sorted).mean(), moments_of(sorted).deviation()};
  std::sort(sorted.begin(), sorted.end());
  const bool single = has_single_elements(featured);
  if (single) {
    for (const MeanAndSpread& element : moments) features.push_back(element.mean());
  }
  if (featured.elements > 1) features.push_back(levels.deviation());
  if (featured.is_series || featured.elements > 1) {
    for (const double share : {0.05, 0.5, 0.95}) features.push_back(quantile(sorted, share));
  }
  if (!featured.is_series) return features;
  features.push_back(std::sqrt(variances.mean()));
  features.push_back(roughness_of(series));
  if (single) {
    for (const MeanAndSpread& element : moments) features.push_back(element.deviation());
  }
  for (std::size_t p = 0; p < kLeastSeriesFrames; ++p) features.push_back(mean_of_part(series, p));
  if (featured.elements > 1) features.push_back(mean_correlation(series, moments));
  const std::vector<double> spectrum = spectrum_of(featured, series);
  features.insert(features.end(), spectrum.begin(), spectrum.end());
  return features;
}

}  // namespace somato
