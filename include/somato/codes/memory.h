#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/signal.h"
#include "somato/core/signal_buffer.h"

namespace somato {

/// The parameters of a memory.
struct MemoryParameters {
  double leak = 0.0;

  static const Declarations<MemoryParameters>& declarations();
};

/// Adds up the frames of an exploration, m(t) = (1 - leak) m(t - 1) + x(t): without a leak the
/// papers' short-term memory, m(t) = x(0) + ... + x(t) (P06 section 2.1); with one, the state of
/// leaky-integrator neurons (P06 section 5, P11 section V; the leak is not given in the papers).
///
/// Frames are added one by one, so that a running loop can use it. Sums are in double precision, in
/// the order of the frames. While all frames are sparse so is the memory, and only what is not zero
/// is visited: without a leak adding a frame costs its stored elements, with one those of the
/// memory too. Sparse and dense frames of the same elements give the same bits.
class Memory {
 public:
  /// An empty memory for frames of `shape`. Throws InvalidArgument unless 0 <= leak <= 1 and there
  /// are at most 2^32 - 1 elements.
  explicit Memory(std::vector<std::size_t> shape, const MemoryParameters& parameters = {});

  /// Forgets everything, as at the start of an exploration.
  void reset();

  /// Adds a frame; throws InvalidArgument when it has another size than the memory.
  void add(const SignalView& frame);

  /// What is held now: sparse while no dense frame was added since the start, with every element
  /// that a frame stored, in ascending order.
  Signal value() const;

  /// The same, flat, into `out`. While dense, nothing is allocated once that has grown.
  void write(SignalBuffer& out) const;

 private:
  void add_sparse(const SignalView& frame);
  void become_dense();
  void write_sparse(SignalBuffer& out) const;

  std::vector<std::size_t> shape_;
  std::size_t size_ = 0;
  double keep_ = 1.0;
  bool dense_ = false;
  std::vector<double> sums_;            // of all elements, or of those that places_ tells
  std::vector<std::uint32_t> indices_;  // sparse: the element of each sum
  std::unordered_map<std::uint32_t, std::size_t> places_;  // sparse: an element's place in sums_
};

}  // namespace somato
