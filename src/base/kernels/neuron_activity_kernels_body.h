// The kernels of neuron_activity_kernels.h, written once; included after kernels_body.h, whose
// vectors they use, in the namespace of one instruction set.

#include <cstddef>

#include "base/kernels/neuron_activity_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

constexpr std::size_t kActivityLanes = 16;
constexpr std::size_t kTermLanes = 8;

// values = change(values) of both halves of each block.
template <typename Change>
inline void change_blocks(float* values, std::size_t blocks, const Change& change) {
  for (std::size_t block = 0; block < blocks; ++block) {
    float* const lanes = values + block * kActivityLanes;
    const auto before = Vector<float>::load(lanes);
    store_halves(change(lower_half(before)), change(upper_half(before)), lanes);
  }
}

void similarities(float* values, std::size_t blocks, double left_out) {
  const auto one = Vector<double>::all(1.0);
  const auto others = Vector<double>::all(left_out);
  change_blocks(values, blocks, [&](Vector<double> squared) {
    return one / (one + square_root(squared + others));
  });
}

float rectify(float* values, std::size_t blocks) {
  auto largest = Vector<float>::all(0.0F);
  for (std::size_t block = 0; block < blocks; ++block) {
    float* const lanes = values + block * kActivityLanes;
    const auto value = rectified(Vector<float>::load(lanes));
    value.store(lanes);
    largest = greatest(largest, value);
  }
  alignas(64) float of_lanes[kActivityLanes];
  largest.store(of_lanes);
  float most = 0.0F;
  for (const float value : of_lanes) most = value > most ? value : most;
  return most;
}

// A few products, each rounded once.
inline Vector<double> power_of(Vector<double> base, unsigned exponent) {
  auto result = Vector<double>::all(1.0);
  for (; exponent > 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = result * base;
    base = base * base;
  }
  return result;
}

void powers(float* values, std::size_t blocks, double largest, unsigned exponent) {
  const auto most = Vector<double>::all(largest);
  change_blocks(values, blocks,
                [&](Vector<double> value) { return power_of(value / most, exponent); });
}

void power_terms(const float* values, std::size_t blocks, double largest, unsigned exponent,
                 double* terms) {
  const auto most = Vector<double>::all(largest);
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto value = Vector<float>::load(values + block * kActivityLanes);
    double* const to = terms + block * kActivityLanes;
    power_of(lower_half(value) / most, exponent).store(to);
    power_of(upper_half(value) / most, exponent).store(to + kTermLanes);
  }
}

void divide(float* values, std::size_t blocks, double divisor) {
  const auto by = Vector<double>::all(divisor);
  change_blocks(values, blocks, [&](Vector<double> value) { return value / by; });
}

}  // namespace

// NOLINTNEXTLINE(misc-definitions-in-headers): each source that includes this has its own namespace
extern const ActivityTable kActivityTable = {similarities, rectify, powers, power_terms, divide};

}  // namespace somato::kernels::SOMATO_KERNELS
