#include "systems/signals/frequency_bands.h"

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"

namespace somato {

std::vector<double> band_edges(const SpectrumParameters& parameters, double high) {
  const double low = parameters.low;
  const auto count = static_cast<double>(parameters.bands);
  const bool geometric = parameters.band_spacing == BandSpacing::kGeometric;
  std::vector<double> edges(parameters.bands + 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double share = static_cast<double>(i) / count;
    edges[i] = geometric ? low * power(high / low, share) : low + (high - low) * share;
  }
  edges.back() = high;
  return edges;
}

double sum_between(std::span<const double> bins, double low, double high) {
  double sum = 0.0;
  for (auto k = static_cast<std::size_t>(std::floor(low + 0.5)); k < bins.size(); ++k) {
    const auto centre = static_cast<double>(k);
    if (centre - 0.5 >= high) break;
    const double width = std::min(high, centre + 0.5) - std::max(low, centre - 0.5);
    sum = std::fma(width, bins[k], sum);
  }
  return sum;
}

}  // namespace somato
