#include "maps/input_slots.h"

#include <algorithm>
#include <cmath>

namespace somato {
namespace {

using kernels::kPending;

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;

// Several at once do not wait for each other.
float greatest_magnitude(std::span<const float> values) {
  std::array<float, kLanes> greatest{};
  std::size_t i = 0;
  for (; i + kLanes <= values.size(); i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float magnitude = std::fabs(values[i + lane]);
      greatest[lane] = magnitude > greatest[lane] ? magnitude : greatest[lane];
    }
  }
  for (; i < values.size(); ++i) greatest[0] = std::max(greatest[0], std::fabs(values[i]));
  return *std::max_element(greatest.begin(), greatest.end());
}

}  // namespace

// An odd number of cache lines keeps equal places of the rows out of each other's way.
InputSlots::InputSlots(std::size_t columns)
    : columns_(columns),
      stride_((((columns + kLanes - 1) / kLanes) | 1) * kLanes),
      rows_(kPending * stride_),
      lanes_(columns * kPending) {}

void InputSlots::write(std::size_t first, const std::vector<std::span<const float>>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::copy(inputs[i].begin(), inputs[i].end(),
              rows_.begin() + static_cast<std::ptrdiff_t>((first + i) * stride_));
  }
}

void InputSlots::write_lanes(std::size_t first, std::size_t count) {
  for (std::size_t start = 0; start < columns_; start += kLanes) {
    const std::size_t end = std::min(start + kLanes, columns_);
    for (std::size_t slot = first; slot < first + count; ++slot) {
      const std::span<const float> from = input(slot);
      float* lane = lanes_.data() + slot;
      for (std::size_t column = start; column < end; ++column) {
        lane[column * kPending] = from[column];
      }
    }
  }
  for (std::size_t slot = first; slot < first + count; ++slot) {
    greatest_[slot] = greatest_magnitude(input(slot));
  }
}

}  // namespace somato
