#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "somato/core/matrix.h"

namespace somato {

/// A copy of weights as 16-bit integers, half as much to read: w = step * integer, with an error of
/// no more than about half a step, for the step of each neuron. In the order of a LaneMatrix.
class RoundedWeights {
 public:
  /// Computes bounds of the magnitudes of `weights`; there are no integers yet.
  explicit RoundedWeights(const LaneMatrix<float>& weights);

  const std::int16_t* block(std::size_t block) const {
    return integers_.data() + block * columns_ * kLanes;
  }

  /// At least the magnitudes of a neuron's weights.
  double greatest(std::size_t neuron) const { return double{greatest_[neuron]}; }
  void set_greatest(std::size_t neuron, double bound);

  double step(std::size_t neuron) const { return double{steps_[neuron]}; }

  /// The length of the difference between a neuron's weights and the integers times their step is
  /// at most this.
  double error(std::size_t neuron) const { return error_of_step_ * step(neuron); }

  /// Begins to round a block whose weights do not exceed greatest().
  void begin(std::size_t block);

  /// Rounds `columns` columns of that block from `start` on.
  void write(std::size_t block, std::size_t start, std::size_t columns, const float* weights);

  /// All columns have been written: greatest() is that of the weights.
  void end(std::size_t block);

 private:
  static constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;

  std::size_t columns_;
  double error_of_step_;
  AlignedVector<std::int16_t> integers_;
  AlignedVector<float> greatest_;
  AlignedVector<float> measured_;
  AlignedVector<float> steps_;
  AlignedVector<float> factors_;  // 1 / steps_
};

}  // namespace somato
