#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "maps/online/online_map.h"
#include "maps/products/product_state.h"
#include "maps/products/product_weights.h"

namespace somato {

/// Learns known samples one at a time by their inner products, without weights.
class ProductLearner : public OnlineMap {
 public:
  /// The map must know samples by products (Som::products()).
  explicit ProductLearner(Som& som);

  Learned learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) override;
  bool write_activity(std::size_t sample, std::span<float> out) override;
  void settle() override;
  Som look() override;

 private:
  Som& som_;
  std::shared_ptr<const ProductWeights> before_;
  ProductState state_;
  bool learned_ = false;
};

}  // namespace somato
