#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/samples.h"

namespace somato {

/// How many values some samples hold in all; of sparse ones, those that are stored.
std::size_t stored_values(const Samples& samples);

/// The elements where any of some sparse samples holds a value, and where each stands among them.
class ElementSet {
 public:
  explicit ElementSet(const Samples& sparse);

  /// Ascending.
  const std::vector<std::uint32_t>& listed() const { return listed_; }

  /// Where `element`, which is one of them, stands.
  std::size_t place_of(std::uint32_t element) const;

 private:
  void mark(const Samples& sparse);
  void sort(const Samples& sparse, std::size_t values);

  std::vector<std::uint32_t> listed_;
  // A bit an element, and how many there are before each word; empty where elements are many more
  // than values.
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;
};

}  // namespace somato
