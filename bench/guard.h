#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato::bench {

using Work = std::function<void()>;
using Digest = std::function<std::uint64_t()>;

/// Counts what `work` does under `name`; the digest taken afterwards stands for the bits of what
/// came out, which are compared between instruction sets.
using Counted = std::function<void(const std::string& name, const Work& work, const Digest& bits)>;

/// Each counts a family: every kernel of its tables, or whole cases.
void count_map_kernels(const Counted& counted);
void count_batch_kernels(const Counted& counted);
void count_online_kernels(const Counted& counted);
void count_product_kernels(const Counted& counted);
void count_t_mpsom_kernels(const Counted& counted);
void count_distance_kernels(const Counted& counted);
void count_activity_kernels(const Counted& counted);
void count_cases(const Counted& counted);

/// Number of kernels of a table: a reminder to count a kernel that is added.
template <typename Table>
inline constexpr std::size_t kKernels = sizeof(Table) / sizeof(Work*);

/// Numbers from 0 to 1.
template <typename Real>
AlignedVector<Real> noise(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  AlignedVector<Real> values(count);
  for (Real& value : values) value = static_cast<Real>(random.uniform());
  return values;
}

template <typename Real>
LaneMatrix<Real> noisy_map(std::size_t rows, std::size_t columns) {
  LaneMatrix<Real> map(rows, columns);
  Random random(7);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t d = 0; d < columns; ++d) map(row, d) = static_cast<Real>(random.uniform());
  }
  return map;
}

/// `before` and one more number: each bit of it counts.
inline std::uint64_t digest_with(std::uint64_t before, double value) {
  constexpr std::uint64_t kFactor = 0x100000001B3;  // FNV-1a, a number at a time
  return (before ^ std::bit_cast<std::uint64_t>(value)) * kFactor;
}

template <typename Values>
std::uint64_t digest_of(const Values& values, std::uint64_t digest = 1) {
  for (const auto value : values) digest = digest_with(digest, static_cast<double>(value));
  return digest;
}

template <typename Real>
std::uint64_t digest_of(const LaneMatrix<Real>& map, std::uint64_t digest = 1) {
  for (std::size_t row = 0; row < map.rows(); ++row) {
    for (std::size_t d = 0; d < map.columns(); ++d) {
      digest = digest_with(digest, static_cast<double>(map(row, d)));
    }
  }
  return digest;
}

}  // namespace somato::bench
