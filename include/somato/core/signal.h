#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace somato {

/// A signal somebody else owns, seen as a flat vector of `size` elements.
///
/// Dense: `indices` is empty and `values` holds all elements. Sparse: `values[i]` stands at
/// `indices[i]`, in ascending order without repeats, and every other element is zero.
struct SignalView {
  std::size_t size = 0;
  bool sparse = false;
  std::span<const std::uint32_t> indices;
  std::span<const float> values;

  /// The view of a dense vector.
  static SignalView dense(std::span<const float> values) {
    return {values.size(), false, {}, values};
  }
};

/// An owned signal, dense or sparse, that knows its shape (row-major; the last axis is contiguous).
class Signal {
 public:
  Signal() = default;

  /// A dense signal; throws InvalidArgument unless `values` has as many elements as `shape` says.
  static Signal dense(std::vector<std::size_t> shape, std::vector<float> values);

  /// A dense vector.
  static Signal dense(std::vector<float> values);

  /// A sparse signal with `values[i]` at flat position `indices[i]`; throws InvalidArgument unless
  /// the indices ascend without repeats and lie inside `shape`.
  static Signal sparse(std::vector<std::size_t> shape, std::vector<std::uint32_t> indices,
                       std::vector<float> values);

  /// A signal of one axis with the values of `view`.
  static Signal copy_of(const SignalView& view);

  const std::vector<std::size_t>& shape() const { return shape_; }
  std::size_t size() const { return size_; }
  bool is_sparse() const { return sparse_; }

  /// The stored values: all elements of a dense signal, the listed ones of a sparse signal.
  std::span<const float> values() const { return values_; }
  std::span<float> values() { return values_; }

  /// Flat positions of the stored values; empty for a dense signal.
  std::span<const std::uint32_t> indices() const { return indices_; }

  SignalView view() const { return {size_, sparse_, indices_, values_}; }

  /// All elements, zeros written out.
  std::vector<float> to_dense() const;

  bool operator==(const Signal&) const = default;

 private:
  std::vector<std::size_t> shape_;
  std::size_t size_ = 0;
  bool sparse_ = false;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

/// Writes all elements of `signal`, zeros included, to `out`; throws InvalidArgument when the sizes
/// differ.
void write_dense(const SignalView& signal, std::span<float> out);

/// The inner product of two signals of equal size, summed in ascending index order in double
/// precision; throws InvalidArgument when the sizes differ.
double inner_product(const SignalView& a, const SignalView& b);

}  // namespace somato
