#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace somato {

/// A non-owning view of a signal as a flat vector of `size` elements.
///
/// Dense: `indices` is empty and `values` contains all elements. Sparse: `values[i]` has the
/// position `indices[i]`, in ascending order without repeats, and every other element is zero.
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

/// An owning signal, dense or sparse, with a shape (row-major; the last axis is contiguous).
class Signal {
 public:
  Signal() = default;

  /// A dense signal; throws InvalidArgument unless the number of `values` matches `shape`.
  static Signal dense(std::vector<std::size_t> shape, std::vector<float> values);

  /// A dense vector.
  static Signal dense(std::vector<float> values);

  /// A sparse signal with `values[i]` at flat position `indices[i]`; throws InvalidArgument unless
  /// the indices ascend without repeats and are inside `shape`.
  static Signal sparse(std::vector<std::size_t> shape, std::vector<std::uint32_t> indices,
                       std::vector<float> values);

  /// A signal with one axis and the values of `view`.
  static Signal copy_of(const SignalView& view);

  /// A signal of the given shape with the values of `view`; throws InvalidArgument if the number of
  /// elements differs.
  static Signal copy_of(const SignalView& view, std::vector<std::size_t> shape);

  const std::vector<std::size_t>& shape() const { return shape_; }
  std::size_t size() const { return size_; }
  bool is_sparse() const { return sparse_; }

  /// The stored values: all elements of a dense signal, the listed ones of a sparse signal.
  std::span<const float> values() const { return values_; }
  std::span<float> values() { return values_; }

  /// Flat positions of the stored values; empty for a dense signal.
  std::span<const std::uint32_t> indices() const { return indices_; }

  SignalView view() const { return {size_, sparse_, indices_, values_}; }

  /// All elements, including zeros.
  std::vector<float> to_dense() const;

  bool operator==(const Signal&) const = default;

 private:
  std::vector<std::size_t> shape_;
  std::size_t size_ = 0;
  bool sparse_ = false;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

/// Reusable memory for one flat signal at a time. It grows to the size of the largest signal and is
/// then filled without allocation.
class SignalBuffer {
 public:
  /// Begins a dense signal; its elements have their previous values, or 0.
  std::vector<float>& begin_dense(std::size_t size);

  /// Begins a sparse signal without elements.
  void begin_sparse(std::size_t size);

  /// Appends an element to a sparse signal.
  void add(std::uint32_t index, float value) {
    indices_.push_back(index);
    values_.push_back(value);
  }

  /// A copy of the signal.
  void assign(const SignalView& signal);

  std::vector<float>& values() { return values_; }

  /// Valid until the buffer is filled again.
  SignalView view() const { return {size_, sparse_, indices_, values_}; }

 private:
  std::size_t size_ = 0;
  bool sparse_ = false;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

/// Writes all elements of `signal`, zeros included, to `out`; throws InvalidArgument if the sizes
/// differ.
void write_dense(const SignalView& signal, std::span<float> out);

/// The inner product of two signals of equal size, summed in ascending index order in double
/// precision; throws InvalidArgument if the sizes differ.
double inner_product(const SignalView& a, const SignalView& b);

}  // namespace somato
