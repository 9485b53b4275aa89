#pragma once

#include <cstddef>
#include <mutex>

#include "maps/products/product_state.h"
#include "maps/som/product_reading.h"
#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// The weights of a map trained by inner products (docs/mathematics/inner-products.md). They are
/// formed when they are first needed: with few samples of many elements forming them costs more
/// than the training, and the results for known samples do not require them. Immutable; can be
/// shared by threads.
class ProductWeights {
 public:
  /// `known` are the samples that the state was prepared for, as they were given.
  ProductWeights(Samples known, ProductState state, std::size_t threads);

  const Samples& known() const { return known_; }
  const ProductState& state() const { return state_; }
  std::size_t threads() const { return threads_; }

  /// The evaluation for a known sample, valid during the lifetime of this object. Throws
  /// InvalidArgument if the sample does not exist.
  ProductReading reading(std::size_t sample) const;

  /// Neurons x stored elements.
  const LaneMatrix<float>& formed() const;

 private:
  std::size_t padded() const { return state_.problem().padded(); }

  Samples known_;
  mutable ProductState state_;  // does not change, but kernels take what could
  std::size_t threads_;
  mutable std::once_flag multiplied_;
  mutable AlignedVector<double> products_;  // known samples x padded neurons
  mutable std::once_flag has_formed_;
  mutable LaneMatrix<float> formed_;
};

}  // namespace somato
