#include "studies/results/claim_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "somato/core/check.h"

namespace somato {
namespace {

// The 97.5 % quantiles of Student's t for 1 to 30 degrees of freedom, from SciPy's t.ppf(0.975, n).
constexpr std::array<double, 30> kQuantiles{
    12.7062047, 4.3026527, 3.1824463, 2.7764451, 2.5705818, 2.4469119, 2.3646243, 2.3060041,
    2.2621572,  2.2281389, 2.2009852, 2.1788128, 2.1603687, 2.1447867, 2.1314495, 2.1199053,
    2.1098156,  2.1009220, 2.0930241, 2.0859634, 2.0796138, 2.0738731, 2.0686576, 2.0638986,
    2.0595386,  2.0555294, 2.0518305, 2.0484071, 2.0452296, 2.0422725};

// The same quantile of the normal distribution.
constexpr double kNormalQuantile = 1.959963985;

// Abramowitz and Stegun, 26.7.5, with three terms: to 1e-6 from 31 degrees of freedom on.
double expanded_quantile(double degrees_of_freedom) {
  const double z = kNormalQuantile;
  const double squared = z * z;
  const double first = z * (squared + 1.0) / 4.0;
  const double second = z * ((5.0 * squared + 16.0) * squared + 3.0) / 96.0;
  const double third = z * (((3.0 * squared + 19.0) * squared + 17.0) * squared - 15.0) / 384.0;
  const double inverse = 1.0 / degrees_of_freedom;
  return z + inverse * (first + inverse * (second + inverse * third));
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value); });
}

std::vector<double> means_of_recordings(const std::vector<double>& values,
                                        const std::vector<std::size_t>& recordings) {
  struct Sum {
    double values = 0.0;
    double count = 0.0;
  };
  std::map<std::size_t, Sum> sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[recordings[i]].values += values[i];
    sums[recordings[i]].count += 1.0;
  }
  std::vector<double> means;
  means.reserve(sums.size());
  for (const auto& [recording, sum] : sums) means.push_back(sum.values / sum.count);
  return means;
}

// The value below which `count` of the values lie, in the order of the iterators.
template <typename Iterator>
double value_after(Iterator value, std::size_t count) {
  while (count >= value->second) {
    count -= value->second;
    ++value;
  }
  return value->first;
}

}  // namespace

std::optional<ClaimRange> central_range(const Distribution& values) {
  std::size_t all = 0;
  for (const auto& [value, times] : values) all += times;
  if (all == 0) return {};
  constexpr double kOutside = (1.0 - kCentralShare) / 2.0;
  constexpr double kRounding = 1e-9;  // 0.05 x 20 must not become 0
  const auto left_out =
      static_cast<std::size_t>(std::floor(kOutside * static_cast<double>(all) + kRounding));
  return ClaimRange{value_after(values.begin(), left_out), value_after(values.rbegin(), left_out)};
}

std::optional<ClaimRange> central_range(const std::vector<double>& values) {
  if (!all_finite(values)) return {};
  Distribution counted;
  for (const double value : values) ++counted[value];
  return central_range(counted);
}

std::optional<double> mean_of_recordings(const std::vector<double>& values,
                                         const std::vector<std::size_t>& recordings) {
  if (values.empty() || values.size() != recordings.size() || !all_finite(values)) return {};
  return Metric{{}, means_of_recordings(values, recordings)}.mean();
}

std::optional<ClaimRange> interval_of_mean(const std::vector<double>& values,
                                           const std::vector<std::size_t>& recordings) {
  if (values.size() != recordings.size() || !all_finite(values)) return {};
  const Metric means{{}, means_of_recordings(values, recordings)};
  const std::size_t count = means.values.size();
  if (count < kLeastRecordings) return {};
  const double error = means.standard_deviation() / std::sqrt(static_cast<double>(count));
  const double half = t_quantile(count - 1) * error;
  return ClaimRange{means.mean() - half, means.mean() + half};
}

double t_quantile(std::size_t degrees_of_freedom) {
  require(degrees_of_freedom > 0, "Student's t needs a degree of freedom");
  if (degrees_of_freedom <= kQuantiles.size()) return kQuantiles[degrees_of_freedom - 1];
  return expanded_quantile(static_cast<double>(degrees_of_freedom));
}

}  // namespace somato
