#include "somato/maps/som.h"

#include <utility>

#include "maps/products/product_weights.h"
#include "maps/som/product_reading.h"

namespace somato {

Som::Som(std::shared_ptr<const ProductWeights> products)
    : parameters_(products->state().problem().parameters()),
      grid_(parameters_.grid()),
      elements_(products->state().problem().elements()),
      products_(std::move(products)) {}

const LaneMatrix<float>& Som::formed() const {
  return products_->formed();
}

bool Som::knows(const Samples& samples) const {
  return products_ && products_->known().is_same_as(samples);
}

Winners Som::winners(const Samples& samples, std::size_t sample, SomWorkspace& workspace) const {
  return knows(samples) ? somato::winners(products_->reading(sample))
                        : winners(samples[sample], workspace);
}

std::size_t Som::winner_among(std::span<const std::size_t> candidates, const Samples& samples,
                              std::size_t sample, SomWorkspace& workspace) const {
  return knows(samples) ? somato::winner_among(candidates, products_->reading(sample))
                        : winner_among(candidates, samples[sample], workspace);
}

double Som::distance(const Samples& samples, std::size_t sample, std::size_t neuron,
                     SomWorkspace& workspace) const {
  return knows(samples) ? somato::distance(products_->reading(sample), neuron)
                        : distance(samples[sample], neuron, workspace);
}

}  // namespace somato
