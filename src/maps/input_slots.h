#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/online_kernels.h"
#include "somato/core/lane_matrix.h"

namespace somato {

static_assert(kernels::kPending == LaneMatrix<float>::kLanes, "slots are a block of rows as well");

/// Up to kPending inputs, a row each, and side by side as kernels::OnlineTable takes some of them.
class InputSlots {
 public:
  explicit InputSlots(std::size_t columns);

  /// Writes neighbouring slots from `first` on. Those behind them are no longer side by side.
  void write(std::size_t first, const std::vector<std::span<const float>>& inputs);

  std::span<const float> input(std::size_t slot) const {
    return {rows_.data() + slot * stride_, columns_};
  }

  /// Products of the input in a slot with those in the first slots, one each.
  void multiply(std::size_t slot, std::size_t count, float* products) const;

  /// Finds the greatest magnitude in a slot.
  void measure(std::size_t slot);
  double greatest(std::size_t slot) const { return double{greatest_[slot]}; }

  /// Puts the first `count` slots side by side.
  void align(std::size_t count);

  /// Those, from element `column` on.
  const float* lanes(std::size_t column) const {
    return lanes_.data() + column * kernels::kPending;
  }

 private:
  void align_columns(std::size_t begin, std::size_t end, std::size_t first, std::size_t last);

  std::size_t columns_;
  std::size_t stride_;
  AlignedVector<float> rows_;
  AlignedVector<float> lanes_;
  std::size_t aligned_ = 0;
  std::array<float, kernels::kPending> greatest_{};
};

}  // namespace somato
