#include "studies/measures/explained_share.h"

#include <algorithm>
#include <cstddef>

#include "base/core/dense_rows.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

double mean_of(const Matrix<float>& rows, std::size_t element) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.rows(); ++i) sum += double{rows(i, element)};
  return sum / static_cast<double>(rows.rows());
}

double explained_share(const Matrix<float>& rows, std::size_t element, const Classes& classes) {
  const double mean = mean_of(rows, element);
  std::vector<double> sums(classes.names.size(), 0.0);  // of differences from the mean
  std::vector<double> counts(classes.names.size(), 0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const double difference = double{rows(i, element)} - mean;
    sums[classes.of_sample[i]] += difference;
    counts[classes.of_sample[i]] += 1.0;
    total += difference * difference;
  }
  if (total <= 0.0) return 0.0;
  double between = 0.0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    between += counts[k] > 0.0 ? sums[k] * sums[k] / counts[k] : 0.0;
  }
  return std::min(between / total, 1.0);
}

}  // namespace

std::vector<double> explained_shares(const Samples& samples, const Classes& classes) {
  const Matrix<float> rows = dense_rows(samples);
  std::vector<double> shares;
  shares.reserve(rows.columns());
  for (std::size_t i = 0; i < rows.columns(); ++i) {
    shares.push_back(explained_share(rows, i, classes));
  }
  return shares;
}

}  // namespace somato
