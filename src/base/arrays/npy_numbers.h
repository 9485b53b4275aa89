#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"

namespace somato {

/// The type of numbers in numpy's notation.
template <typename T>
constexpr std::string_view npy_type_of() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double> ||
                std::is_same_v<T, std::int64_t>);
  if (std::is_same_v<T, float>) return "<f4";
  return std::is_same_v<T, double> ? "<f8" : "<i8";
}

/// The bytes of an NPY file of numbers in row-major order; without dimensions it is a single
/// number.
template <typename T>
std::string npy_of_numbers(std::span<const T> numbers, std::span<const std::size_t> shape) {
  std::string bytes = npy_file_start(npy_type_of<T>(), shape);
  bytes.reserve(bytes.size() + numbers.size_bytes());
  for (const T number : numbers) append_little_endian(bytes, number);
  return bytes;
}

}  // namespace somato
