#include "studies/inference/match_predictors.h"

#include <algorithm>
#include <cmath>

#include "studies/inference/acceptance.h"
#include "systems/signals/mean_and_spread.h"

namespace somato {
namespace {

// The sorted values of a column.
class SortedColumn {
 public:
  explicit SortedColumn(std::vector<double> values) : values_(std::move(values)) {
    std::sort(values_.begin(), values_.end());
  }

  double place_of_member(double value) const {
    const auto [first, last] = std::equal_range(values_.begin(), values_.end(), value);
    const auto twice = (first - values_.begin()) + (last - values_.begin());
    return static_cast<double>(twice) / (2.0 * static_cast<double>(values_.size()));
  }

  double place_of(double value) const {
    const double inside = std::clamp(value, values_.front(), values_.back());
    const auto above = std::lower_bound(values_.begin(), values_.end(), inside);
    if (*above == inside) return place_of_member(inside);
    const double below = *(above - 1);
    const double share = (inside - below) / (*above - below);
    return (1.0 - share) * place_of_member(below) + share * place_of_member(*above);
  }

 private:
  std::vector<double> values_;
};

MeanAndSpread moments_of(std::span<const double> values) {
  MeanAndSpread moments;
  for (const double value : values) moments.add(value);
  return moments;
}

double deviation_of(const MeanAndSpread& moments) {
  return std::sqrt(moments.squares() / static_cast<double>(moments.count()));
}

}  // namespace

MatchPredictors places_among_draws(const Matrix<double>& statistics,
                                   std::span<const double> observed) {
  MatchPredictors predictors{Matrix<double>(statistics.rows(), statistics.columns()), {}};
  for (std::size_t c = 0; c < statistics.columns(); ++c) {
    const SortedColumn column(places_of(statistics, c));
    for (std::size_t i = 0; i < statistics.rows(); ++i)
      predictors.of_draws(i, c) = column.place_of_member(statistics(i, c));
    predictors.observed.push_back(column.place_of(observed[c]));
  }
  return predictors;
}

std::vector<double> explained_shares(const Matrix<double>& predictors, const Matrix<double>& places,
                                     std::span<const std::size_t> groups) {
  const std::vector<double> anywhere(places.columns(), 0.0);
  const auto predictions = ridge_predictions(places, predictors, anywhere, groups);
  std::vector<double> shares;
  for (std::size_t c = 0; c < predictors.columns(); ++c) {
    const double deviation = deviation_of(moments_of(places_of(predictors, c)));
    const double left = deviation > 0.0 ? predictions[c].error / deviation : 1.0;
    shares.push_back(1.0 - left * left);
  }
  return shares;
}

std::vector<RidgePrediction> predicted_places(const MatchPredictors& predictors,
                                              const Matrix<double>& places,
                                              std::span<const std::size_t> groups) {
  auto predictions = ridge_predictions(predictors.of_draws, places, predictors.observed, groups);
  for (std::size_t u = 0; u < predictions.size(); ++u) {
    const MeanAndSpread moments = moments_of(places_of(places, u));
    const double deviation = deviation_of(moments);
    RidgePrediction& prediction = predictions[u];
    if (prediction.error < deviation) continue;
    prediction.of_rows.assign(places.rows(), moments.mean());
    prediction.of_given = moments.mean();
    prediction.error = deviation;
  }
  return predictions;
}

bool is_outside(const RidgePrediction& prediction) {
  const auto [least, greatest] =
      std::minmax_element(prediction.of_rows.begin(), prediction.of_rows.end());
  return prediction.of_given < *least - prediction.error ||
         prediction.of_given > *greatest + prediction.error;
}

}  // namespace somato
