#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom_parameters.h"

namespace somato {

/// What came in last for one input of a T-MPSOM, normalized, and the partial activations it gave:
/// both often serve again.
class TMpsomHeard {
 public:
  TMpsomHeard(std::size_t elements, std::size_t padded_neurons);

  std::size_t size() const { return values_.size(); }

  /// Whether no element is another than in the last signal; NaN is another than itself.
  bool is_again(const SignalView& signal) const;

  /// Takes a signal of size() elements and forgets the partial activations. Throws
  /// InvalidArgument, and changes nothing, when it holds a value that is not finite.
  void take(const SignalView& signal, TMpsomNorm norm);

  /// Whether no element of the last signal is other than zero.
  bool is_zero() const { return count_ == 0; }

  /// Elements from `first` to before `end` that are not zero: where they stand, and what they are,
  /// normalized. With a norm, elements below 1e-18 of the length count as zero, and may be among
  /// them.
  struct Elements {
    const std::uint32_t* places;
    const float* values;
    std::size_t count;
  };
  Elements elements(std::size_t first, std::size_t end) const;

  /// Writes all elements, normalized, to the front of `out`.
  void write_dense(std::span<float> out) const;

  /// The squared length of the normalized elements.
  float squared_length() const { return squared_length_; }

  /// Partial activations, one a neuron, and the state of the weights they are of; 0: none.
  std::span<float> partial() { return partial_; }
  std::span<const float> partial() const { return partial_; }
  std::uint64_t state() const { return state_; }
  void set_state(std::uint64_t state) { state_ = state; }

 private:
  std::size_t take_elements(const SignalView& signal);

  std::size_t count_ = 0;  // of elements that are not zero: the others add nothing
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;  // as they came
  std::vector<float> normalized_;
  std::vector<std::uint32_t> ranks_;  // how many of `indices_` are below each element
  float squared_length_ = 0.0F;
  AlignedVector<float> partial_;
  std::uint64_t state_ = 0;
};

}  // namespace somato
