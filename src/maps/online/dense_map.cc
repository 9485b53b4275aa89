#include "maps/online/dense_map.h"

#include <algorithm>

namespace somato {

// As many of the first inputs as the learner accepts at once, up to one with an element without
// weights; returns whether there is any.
bool DenseMap::prepare(std::span<const OnlineInput> inputs) {
  const std::size_t most = inputs.size() == 1 ? 1 : std::min(learner_.ahead(), inputs.size());
  prepared_.resize(std::max(prepared_.size(), most));
  expected_.clear();
  while (expected_.size() < most) {
    std::span<const float> x = som_.prepare(inputs[expected_.size()].values, workspace_);
    if (workspace_.left_out_ > 0.0) break;
    if (most > 1 && x.data() == workspace_.input_.data()) {
      std::vector<float>& kept = prepared_[expected_.size()];
      kept.assign(x.begin(), x.end());
      x = kept;
    }
    expected_.push_back(x);
  }
  return !expected_.empty();
}

Learned DenseMap::learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) {
  if (!prepare(inputs)) return {};
  learner_.expect(expected_);
  Learned learned{expected_.size(), 0};
  for (std::size_t i = 0; i < expected_.size(); ++i) {
    learned.winner = learner_.learn(steps[i].learning_rate, steps[i].radius);
  }
  return learned;
}

}  // namespace somato
