#pragma once

#include <span>
#include <vector>

#include "maps/online/dense_learner.h"
#include "maps/online/online_map.h"

namespace somato {

/// Learns inputs by all their elements: gets them ready for a DenseLearner, several at once.
class DenseMap : public OnlineMap {
 public:
  DenseMap(Som& som, ThreadTeam& team) : som_(som), learner_(som, team) {}

  Learned learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) override;
  void settle() override { learner_.settle(); }
  Som look() override { return learner_.look(); }

 private:
  bool prepare(std::span<const OnlineInput> inputs);

  Som& som_;
  DenseLearner learner_;
  SomWorkspace workspace_;
  std::vector<std::vector<float>> prepared_;
  std::vector<std::span<const float>> expected_;
};

}  // namespace somato
