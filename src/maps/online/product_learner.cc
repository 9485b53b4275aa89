#include "maps/online/product_learner.h"

namespace somato {

ProductLearner::ProductLearner(Som& som)
    : som_(som), before_(som.products()), state_(before_->state()) {}

Learned ProductLearner::learn(std::span<const OnlineInput> inputs,
                              std::span<const LearningStep> steps) {
  learned_ = true;
  Learned learned;
  for (; learned.inputs < inputs.size() && inputs[learned.inputs].item; ++learned.inputs) {
    const LearningStep& step = steps[learned.inputs];
    learned.winner = state_.learn(*inputs[learned.inputs].item, step.learning_rate, step.radius);
  }
  return learned;
}

bool ProductLearner::write_activity(std::size_t sample, std::span<float> out) {
  AlignedVector<double> products(state_.problem().padded());
  state_.products_with(sample, products);
  activity(state_.problem().reading(sample, products, state_.squared_lengths()),
           state_.problem().parameters(), out);
  return true;
}

void ProductLearner::settle() {
  if (!learned_) return;
  learned_ = false;
  som_ = look();
}

Som ProductLearner::look() {
  return Som(std::make_shared<const ProductWeights>(before_->known(), state_, before_->threads()));
}

}  // namespace somato
