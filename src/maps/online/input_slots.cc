#include "maps/online/input_slots.h"

#include <algorithm>
#include <cmath>

#include "base/core/lanes.h"
#include "base/kernels/kernels.h"

namespace somato {
namespace {

// Several at once do not wait for each other.
float greatest_magnitude(std::span<const float> values) {
  std::array<float, kFloatLanes> greatest{};
  std::size_t i = 0;
  for (; i + kFloatLanes <= values.size(); i += kFloatLanes) {
    for (std::size_t lane = 0; lane < kFloatLanes; ++lane) {
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
      padded_((columns + kFloatLanes - 1) / kFloatLanes * kFloatLanes),
      stride_((padded_ / kFloatLanes | 1) * kFloatLanes),
      rows_(kernels::kPending * stride_) {}

void InputSlots::write(std::size_t first, const std::vector<std::span<const float>>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::copy(inputs[i].begin(), inputs[i].end(),
              rows_.begin() + static_cast<std::ptrdiff_t>((first + i) * stride_));
  }
}

// Up to a chunk of elements is summed in order, so that zeros among them change nothing.
void InputSlots::multiply(std::size_t slot, std::size_t count, std::size_t chunk,
                          float* products) const {
  const auto& kernels = kernels::online_table();
  const float* x = rows_.data() + slot * stride_;
  if (columns_ > kernels::kChunk) {
    kernels.multiply_long_rows(rows(0, 0), count, x, padded_, products);
  } else {
    kernels.multiply_rows(rows(0, 0), count, x, columns_, chunk, products);
  }
}

void InputSlots::measure(std::size_t slot) {
  greatest_[slot] = greatest_magnitude(input(slot));
}

}  // namespace somato
