#pragma once

#include <cstddef>

namespace somato::testing {

/// Whether this build counts allocations: sanitizers bring their own operator new, so not there.
bool counts_allocations();

/// Counts what the current thread allocates through operator new, in any form, while it lives.
class AllocationCounter {
 public:
  AllocationCounter();
  std::size_t count() const;

  /// The most bytes that the current thread held at once, beyond what it held at the start.
  std::size_t most_bytes() const;

 private:
  std::size_t before_;
  std::size_t held_before_;
};

}  // namespace somato::testing
