#include "systems/signals/mean_removal.h"

#include <vector>

namespace somato {
namespace {

std::vector<double> element_means(const Matrix<float>& frames) {
  std::vector<double> means(frames.columns(), 0.0);
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    for (std::size_t j = 0; j < means.size(); ++j) means[j] += double{frames(i, j)};
  }
  for (double& mean : means) mean /= static_cast<double>(frames.rows());
  return means;
}

}  // namespace

Matrix<float> mean_removed(Matrix<float> frames) {
  if (frames.empty()) return frames;
  const std::vector<double> means = element_means(frames);
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    for (std::size_t j = 0; j < means.size(); ++j) {
      frames(i, j) = static_cast<float>(double{frames(i, j)} - means[j]);
    }
  }
  return frames;
}

}  // namespace somato
