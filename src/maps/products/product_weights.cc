#include "maps/products/product_weights.h"

#include <utility>

#include "somato/core/check.h"

namespace somato {

ProductWeights::ProductWeights(Samples known, ProductState state, std::size_t threads)
    : known_(std::move(known)), state_(std::move(state)), threads_(threads) {}

ProductReading ProductWeights::reading(std::size_t sample) const {
  require(sample < known_.count(), "the sample is not among those known to the map");
  std::call_once(multiplied_, [&] {
    products_.resize(known_.count() * padded());
    for (std::size_t known = 0; known < known_.count(); ++known) {
      state_.products_with(known, {&products_[known * padded()], padded()});
    }
  });
  return state_.problem().reading(sample, {&products_[sample * padded()], padded()},
                                  state_.squared_lengths());
}

const LaneMatrix<float>& ProductWeights::formed() const {
  std::call_once(has_formed_, [&] { formed_ = state_.form(threads_); });
  return formed_;
}

}  // namespace somato
