#include "maps/online/rounded_weights.h"

#include <algorithm>
#include <cmath>

#include "base/kernels/online_kernels.h"

namespace somato {
namespace {

// Some room below 2^15 for rounding on the way to an integer.
constexpr float kGreatestRoundedWeight = 32700.0F;

// Half a step, and intermediate rounding errors.
constexpr double kErrorOfStep = 0.51;

// Steps and their reciprocals stay far within single precision.
constexpr float kLeastMagnitude = 0x1p-90F;

// More than a rounding.
constexpr double kUp = 1.0 + 0x1p-20;

}  // namespace

RoundedWeights::RoundedWeights(const LaneMatrix<float>& weights)
    : columns_(weights.columns()),
      error_of_step_(kErrorOfStep * std::sqrt(static_cast<double>(weights.columns()))),
      integers_(weights.padded_rows() * weights.columns()),
      greatest_(weights.padded_rows()),
      measured_(weights.padded_rows()),
      steps_(weights.padded_rows()),
      factors_(weights.padded_rows()) {
  for (std::size_t block = 0; block < weights.blocks(); ++block) {
    write(block, 0, columns_, weights.data() + block * columns_ * kLanes);
    end(block);
  }
}

void RoundedWeights::set_greatest(std::size_t neuron, double bound) {
  greatest_[neuron] = static_cast<float>(bound * kUp);
}

void RoundedWeights::begin(std::size_t block) {
  for (std::size_t neuron = block * kLanes; neuron < (block + 1) * kLanes; ++neuron) {
    steps_[neuron] = std::max(greatest_[neuron], kLeastMagnitude) / kGreatestRoundedWeight;
    factors_[neuron] = 1.0F / steps_[neuron];
    measured_[neuron] = 0.0F;
  }
}

void RoundedWeights::write(std::size_t block, std::size_t start, std::size_t columns,
                           const float* weights) {
  kernels::online_table().round_tile(weights, columns, factors_.data() + block * kLanes,
                                     integers_.data() + (block * columns_ + start) * kLanes,
                                     measured_.data() + block * kLanes);
}

void RoundedWeights::end(std::size_t block) {
  std::copy_n(measured_.data() + block * kLanes, kLanes, greatest_.data() + block * kLanes);
}

}  // namespace somato
