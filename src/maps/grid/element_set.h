#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/samples.h"

namespace somato {

/// The total number of values of some samples; for sparse samples, of stored values.
std::size_t stored_values(const Samples& samples);

/// The elements for which any of some sparse samples has a value, and their positions.
class ElementSet {
 public:
  explicit ElementSet(const Samples& sparse);

  /// Ascending.
  const std::vector<std::uint32_t>& listed() const { return listed_; }

  /// The position of `element`, which must be included.
  std::size_t place_of(std::uint32_t element) const;

 private:
  void mark(const Samples& sparse);
  void sort(const Samples& sparse, std::size_t values);

  std::vector<std::uint32_t> listed_;
  // One bit per element, and the number of set bits before each word; empty if there are many more
  // elements than values.
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;
};

}  // namespace somato
