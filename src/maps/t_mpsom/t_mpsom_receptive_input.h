#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// The last signal of one input of a T-MPSOM, normalized, and its partial activations: both can
/// often be reused.
class TMpsomReceptiveInput {
 public:
  TMpsomReceptiveInput(std::size_t elements, std::size_t padded_neurons);

  std::size_t size() const { return values_.size(); }

  /// Whether every element equals that of the last signal; NaN does not equal itself.
  bool is_again(const SignalView& signal) const;

  /// Sets a signal of size() elements and discards the partial activations. Throws InvalidArgument,
  /// and changes nothing, if it contains a value that is not finite.
  void take(const SignalView& signal, TMpsomNorm norm);

  /// Whether all elements of the last signal are zero.
  bool is_zero() const { return count_ == 0; }

  /// The non-zero elements from `first` to before `end`: positions and normalized values. With a
  /// norm, elements below 1e-18 of the length are treated as zero, and may be included.
  struct Elements {
    const std::uint32_t* places;
    const float* values;
    std::size_t count;
  };
  Elements elements(std::size_t first, std::size_t end) const;

  /// Writes all elements, normalized, to the start of `out`.
  void write_dense(std::span<float> out) const;

  /// The squared length of the normalized elements.
  float squared_length() const { return squared_length_; }

  /// Partial activations, one per neuron, and the state of the weights that they belong to; 0:
  /// none.
  std::span<float> partial() { return partial_; }
  std::span<const float> partial() const { return partial_; }
  std::uint64_t state() const { return state_; }
  void set_state(std::uint64_t state) { state_ = state; }

 private:
  std::size_t take_elements(const SignalView& signal);

  std::size_t count_ = 0;  // of non-zero elements; the others contribute nothing
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;  // before normalization
  std::vector<float> normalized_;
  std::vector<std::uint32_t> ranks_;  // number of `indices_` below each element
  float squared_length_ = 0.0F;
  AlignedVector<float> partial_;
  std::uint64_t state_ = 0;
};

}  // namespace somato
