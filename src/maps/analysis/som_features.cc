#include "somato/maps/som_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/core/dense_rows.h"
#include "base/core/threads.h"
#include "somato/core/check.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

double explained_share(double residual, double squares) {
  return squares > 0.0 ? 1.0 - residual / squares : kUndefined;
}

// The samples of a part that are expanded at once.
std::size_t rows_at_once(std::size_t features) {
  constexpr std::size_t kMostValues = std::size_t{1} << 22;
  return std::max<std::size_t>(1, kMostValues / std::max<std::size_t>(1, features));
}

}  // namespace

FeatureMeasurement::FeatureMeasurement(const Som& som, std::size_t threads,
                                       std::vector<std::size_t> group_of_neuron, std::size_t groups)
    : som_(som),
      threads_(threads),
      group_of_neuron_(std::move(group_of_neuron)),
      means_(som.input_size()),
      squares_(som.input_size()),
      residuals_(som.input_size()),
      counts_(som.input_size()),
      group_sums_(groups, som.input_size()),
      group_counts_(groups, som.input_size()) {
  require(group_of_neuron_.empty() || group_of_neuron_.size() == som.neurons(),
          "FeatureMeasurement: each neuron needs a group");
}

void FeatureMeasurement::add(const Samples& samples, std::span<const std::size_t> winners) {
  require(samples.count() == winners.size(), "FeatureMeasurement: each sample needs a winner");
  require(samples.size() == som_.input_size(), "FeatureMeasurement: samples of another size");
  Samples storage;
  SomParameters in_units = som_.parameters();
  in_units.relevances.clear();
  const Samples& prepared = prepared_samples(in_units, samples, storage);
  const std::size_t most = rows_at_once(samples.size());
  for (std::size_t first = 0; first < prepared.count(); first += most) {
    std::vector<std::size_t> numbers(std::min(most, prepared.count() - first));
    std::iota(numbers.begin(), numbers.end(), first);
    const bool is_whole = numbers.size() == prepared.count();
    add_to_groups(is_whole ? prepared : prepared.subset(numbers),
                  winners.subspan(first, numbers.size()));
  }
}

// Means and sums of squares by the recurrence of Welford (1962), which loses no digits of a small
// variance around a large mean.
void FeatureMeasurement::add_to_groups(const Samples& samples,
                                       std::span<const std::size_t> winners) {
  const Matrix<float> rows = dense_rows(samples);
  for_each_range(samples.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      const std::size_t group =
          group_of_neuron_.empty() ? group_sums_.rows() : group_of_neuron_[winners[i]];
      for (std::size_t d = begin; d < end; ++d) {
        const double value{rows(i, d)};
        if (std::isnan(value)) continue;
        const double change = value - means_[d];
        means_[d] += change / static_cast<double>(++counts_[d]);
        squares_[d] += change * (value - means_[d]);
        const double error = value - double{som_.weight(winners[i], d)};
        residuals_[d] += error * error;
        if (group >= group_sums_.rows()) continue;
        group_sums_(group, d) += value;
        ++group_counts_(group, d);
      }
    }
  });
}

std::vector<FeatureMeasures> FeatureMeasurement::features() const {
  std::vector<FeatureMeasures> features(means_.size());
  for (std::size_t d = 0; d < features.size(); ++d) {
    features[d] =
        counts_[d] == 0
            ? FeatureMeasures{kUndefined, kUndefined, kUndefined}
            : FeatureMeasures{means_[d], std::sqrt(squares_[d] / static_cast<double>(counts_[d])),
                              explained_share(residuals_[d], squares_[d])};
  }
  return features;
}

double FeatureMeasurement::explained_variance() const {
  return explained_share(std::accumulate(residuals_.begin(), residuals_.end(), 0.0),
                         std::accumulate(squares_.begin(), squares_.end(), 0.0));
}

std::vector<FeatureDifference> FeatureMeasurement::differences(std::size_t group) const {
  require(group < group_sums_.rows(), "FeatureMeasurement: there is no such group");
  std::vector<FeatureDifference> differences;
  const std::vector<FeatureMeasures> all = features();
  for (std::size_t d = 0; d < all.size(); ++d) {
    const std::size_t count = group_counts_(group, d);
    if (count == 0) continue;
    const double mean = group_sums_(group, d) / static_cast<double>(count);
    const bool varies = all[d].deviation > 0.0;
    differences.push_back({d, varies ? (mean - all[d].mean) / all[d].deviation : 0.0});
  }
  std::sort(differences.begin(), differences.end(), [](const auto& a, const auto& b) {
    const double of_a = std::abs(a.difference);
    const double of_b = std::abs(b.difference);
    return of_a != of_b ? of_a > of_b : a.feature < b.feature;
  });
  return differences;
}

}  // namespace somato
