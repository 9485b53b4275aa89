#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/online_kernels.h"
#include "somato/core/lane_matrix.h"

namespace somato {

static_assert(kernels::kPending == LaneMatrix<float>::kLanes, "slots are a block of rows as well");

/// Up to kPending inputs side by side, in both orders that the kernels take.
class InputSlots {
 public:
  explicit InputSlots(std::size_t columns);

  /// Writes neighbouring slots from `first` on, in the first order.
  void write(std::size_t first, const std::vector<std::span<const float>>& inputs);

  /// Copies `count` slots from `first` on into the second order, and measures them.
  void write_lanes(std::size_t first, std::size_t count);

  std::span<const float> input(std::size_t slot) const {
    return {rows_.data() + slot * stride_, columns_};
  }

  /// The greatest magnitude in a slot whose lanes have been written.
  double greatest(std::size_t slot) const { return double{greatest_[slot]}; }

  /// From element `column` on, as kernels::OnlineTable takes inputs.
  const float* lanes(std::size_t column) const {
    return lanes_.data() + column * kernels::kPending;
  }

 private:
  std::size_t columns_;
  std::size_t stride_;
  AlignedVector<float> rows_;
  AlignedVector<float> lanes_;
  std::array<float, kernels::kPending> greatest_{};
};

}  // namespace somato
