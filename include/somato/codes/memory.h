#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/signal.h"

namespace somato {

/// The parameters of a memory.
struct MemoryParameters {
  double leak = 0.0;

  static const Declarations<MemoryParameters>& declarations();
};

/// Sums the frames of an exploration, m(t) = (1 - leak) m(t - 1) + x(t): without a leak the papers'
/// short-term memory, m(t) = x(0) + ... + x(t) (P06 section 2.1); with one, the state of
/// leaky-integrator neurons (P06 section 5, P11 section V; the leak is not given in the papers).
///
/// Frames are added one by one, so that it can be used live. Sums are in double precision, in the
/// order of the frames. While all frames are sparse so is the memory, and only non-zero elements
/// are visited: without a leak, the cost of adding a frame is its number of stored elements, with a
/// leak also that of the memory. Sparse and dense frames of the same elements give the same bits.
class Memory {
 public:
  /// An empty memory for frames of `shape`. Throws InvalidArgument unless 0 <= leak <= 1 and there
  /// are at most 2^32 - 1 elements.
  explicit Memory(std::vector<std::size_t> shape, const MemoryParameters& parameters = {});

  /// Resets the memory, as at the start of an exploration.
  void reset();

  /// Adds a frame; throws InvalidArgument if its size differs from that of the memory.
  void add(const SignalView& frame);

  /// The current state: sparse if no dense frame was added since the start, with every element that
  /// a frame stored, in ascending order.
  Signal value() const;

  /// The same, flat, into `out`. If dense, does not allocate if `out` is large enough.
  void write(SignalBuffer& out) const;

 private:
  // Sums of neighbouring elements, since those that a frame stores often lie side by side.
  struct Page {
    static constexpr std::size_t kSums = 256;

    void clear();
    void add(std::size_t place, double value);

    std::array<double, kSums> sums{};
    std::array<std::uint64_t, kSums / 64> stored{};  // a bit for each element that a frame stored
  };

  void add_sparse(const SignalView& frame);
  void become_dense();
  void decay();
  void write_sparse(SignalBuffer& out) const;
  Page& page_of(std::uint32_t element);

  template <typename Visit>
  void for_each_stored(const Visit& visit) const;

  std::vector<std::size_t> shape_;
  std::size_t size_ = 0;
  double keep_ = 1.0;
  bool dense_ = false;
  std::vector<double> sums_;                 // dense: of all elements
  std::vector<std::uint32_t> page_numbers_;  // sparse: 1 + the place in pages_, or 0, by element
  std::deque<Page> pages_;                   // kept from one exploration to the next
  std::size_t pages_used_ = 0;
};

}  // namespace somato
