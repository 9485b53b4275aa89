#include "maps/som/map_rows.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/core/lanes.h"

namespace somato {

LaneMatrix<float>& weights_to_change(Som& som) {
  if (som.products_) {
    som.weights_ = som.formed();
    som.products_.reset();
  }
  return som.weights_;
}

void normalize_rows(LaneMatrix<float>& weights, AlignedVector<float>& factors) {
  factors.resize(weights.padded_rows());
  const auto& kernels = kernels::table<float>();
  kernels.squared_norms(kernels::lanes(std::as_const(weights)), factors.data());
  for (float& factor : factors) factor = factor > 0.0F ? 1.0F / std::sqrt(factor) : 1.0F;
  kernels.scale_rows(kernels::lanes(weights), factors.data());
}

bool has_weights_for(const Som& som, const Samples& samples) {
  if (som.elements().all()) return true;
  std::vector<float> stored(som.elements().count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    if (som.elements().gather(samples[i], stored) > 0.0) return false;
  }
  return true;
}

}  // namespace somato
