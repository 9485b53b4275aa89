#pragma once

#include <cstddef>
#include <memory>

#include "maps/sample_products.h"
#include "somato/maps/known_samples.h"

namespace somato {

/// What the library does with known samples.
class KnownPreparation {
 public:
  /// Known samples that somebody else keeps alive.
  static KnownSamples borrow(const Samples& samples);

  /// As maps see them that scale inputs to length 1, or others; shared by all who ask.
  static std::shared_ptr<const SampleProducts> products(const KnownSamples& known, bool normalized,
                                                        std::size_t threads);
};

}  // namespace somato
