#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/kernels/online_kernels.h"
#include "somato/core/matrix.h"

namespace somato {

/// Up to kPending inputs, one per row, which starts on a cache line and is padded with zeros.
class InputSlots {
 public:
  explicit InputSlots(std::size_t columns);

  /// Writes neighbouring slots from `first` on.
  void write(std::size_t first, const std::vector<std::span<const float>>& inputs);

  std::span<const float> input(std::size_t slot) const {
    return {rows_.data() + slot * stride_, columns_};
  }

  /// All from slot `first` on, from element `column` on.
  kernels::InputRows rows(std::size_t first, std::size_t column) const {
    return {rows_.data() + first * stride_ + column, stride_};
  }

  /// Elements with the zeros behind them.
  std::size_t padded() const { return padded_; }

  /// Products of the input in a slot with those in the first slots, one each; few columns are
  /// summed in chunks.
  void multiply(std::size_t slot, std::size_t count, std::size_t chunk, float* products) const;

  /// Finds the greatest magnitude in a slot.
  void measure(std::size_t slot);
  double greatest(std::size_t slot) const { return double{greatest_[slot]}; }

 private:
  std::size_t columns_;
  std::size_t padded_;
  std::size_t stride_;
  AlignedVector<float> rows_;
  std::array<float, kernels::kPending> greatest_{};
};

}  // namespace somato
