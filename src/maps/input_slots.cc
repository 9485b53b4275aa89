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
  aligned_ = std::min(aligned_, first);
}

// Behind its end a row has zeros.
void InputSlots::multiply(std::size_t slot, std::size_t count, float* products) const {
  const std::size_t padded = (columns_ + kLanes - 1) / kLanes * kLanes;
  kernels::online_table().multiply_rows(rows_.data(), stride_, count, rows_.data() + slot * stride_,
                                        padded, products);
}

void InputSlots::measure(std::size_t slot) {
  greatest_[slot] = greatest_magnitude(input(slot));
}

void InputSlots::align(std::size_t count) {
  for (std::size_t start = 0; start < columns_ && aligned_ < count; start += kLanes) {
    align_columns(start, std::min(start + kLanes, columns_), aligned_, count);
  }
  aligned_ = std::max(aligned_, count);
}

void InputSlots::align_columns(std::size_t begin, std::size_t end, std::size_t first,
                               std::size_t last) {
  for (std::size_t slot = first; slot < last; ++slot) {
    const std::span<const float> from = input(slot);
    float* lane = lanes_.data() + slot;
    for (std::size_t column = begin; column < end; ++column) {
      lane[column * kPending] = from[column];
    }
  }
}

}  // namespace somato
