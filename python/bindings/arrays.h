#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "nanobind/nanobind.h"
#include "nanobind/ndarray.h"
#include "somato/core/samples.h"

namespace somato::python {

/// Samples as Python passes them: one per row, in C order, not copied.
using Rows =
    nanobind::ndarray<const float, nanobind::ndim<2>, nanobind::c_contig, nanobind::device::cpu>;

template <typename T>
using Numbers =
    nanobind::ndarray<const T, nanobind::ndim<1>, nanobind::c_contig, nanobind::device::cpu>;

/// `count` rows from `first` on, as samples; valid during the lifetime of `rows`.
inline Samples samples_of(const Rows& rows, std::size_t first, std::size_t count) {
  const std::size_t size = rows.shape(1);
  return Samples::view_of({rows.data() + first * size, count * size}, size);
}

/// All rows.
inline Samples samples_of(const Rows& rows) {
  return samples_of(rows, 0, rows.shape(0));
}

/// An array of numpy that owns `values`.
template <typename T>
nanobind::object array_of(std::vector<T> values, std::span<const std::size_t> shape) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* data = owned->data();
  const nanobind::capsule owner(owned.get(), [](void* memory) noexcept {
    delete static_cast<std::vector<T>*>(memory);  // NOLINT(cppcoreguidelines-owning-memory)
  });
  owned.release();
  return nanobind::cast(
      nanobind::ndarray<nanobind::numpy, T>(data, shape.size(), shape.data(), owner));
}

/// A new array of numpy, whose values are not set, and these values.
template <typename T>
std::pair<nanobind::object, std::span<T>> new_array(std::span<const std::size_t> shape) {
  std::size_t count = 1;
  for (const std::size_t size : shape) count *= size;
  std::unique_ptr<T[]> values(new T[count]);
  const nanobind::capsule owner(values.get(), [](void* memory) noexcept {
    delete[] static_cast<T*>(memory);  // NOLINT(cppcoreguidelines-owning-memory)
  });
  T* data = values.release();
  return {nanobind::cast(
              nanobind::ndarray<nanobind::numpy, T>(data, shape.size(), shape.data(), owner)),
          {data, count}};
}

template <typename T>
nanobind::object array_of(std::vector<T> values) {
  const std::size_t shape[] = {values.size()};
  return array_of(std::move(values), std::span<const std::size_t>(shape));
}

/// Numbers of neurons, samples or classes as an array.
inline nanobind::object integers(const std::vector<std::size_t>& numbers) {
  return array_of(std::vector<std::int64_t>(numbers.begin(), numbers.end()));
}

/// The reverse.
inline std::vector<std::size_t> sizes(const Numbers<std::int64_t>& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

}  // namespace somato::python
