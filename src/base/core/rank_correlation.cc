#include "base/core/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "somato/core/check.h"

namespace somato {
namespace {

double sum_of_squares(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

}  // namespace

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  ranks.reserve(values.size());
  for (const double value : values) {
    const auto is_less = [&](double other) { return other < value; };
    const auto less = std::count_if(values.begin(), values.end(), is_less);
    const auto equal = std::count(values.begin(), values.end(), value);
    ranks.push_back(static_cast<double>(less) + (static_cast<double>(equal) + 1.0) / 2.0);
  }
  return ranks;
}

std::vector<double> centred_ranks(const std::vector<double>& values) {
  std::vector<double> ranks = ranks_of(values);
  for (double& rank : ranks) rank -= (static_cast<double>(ranks.size()) + 1.0) / 2.0;
  return ranks;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  return correlation_of_centred_ranks(centred_ranks(a), centred_ranks(b));
}

double correlation_of_centred_ranks(const std::vector<double>& a, const std::vector<double>& b) {
  require(a.size() == b.size(), "a rank correlation needs two lists of equal length");
  const double spread = std::sqrt(sum_of_squares(a) * sum_of_squares(b));
  if (spread <= 0.0) return 0.0;
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / spread;
}

}  // namespace somato
