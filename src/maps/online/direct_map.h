#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/core/thread_team.h"
#include "maps/grid/neighbourhood.h"
#include "maps/online/online_map.h"
#include "maps/reading/known_elements.h"
#include "somato/core/matrix.h"
#include "somato/maps/som.h"

namespace somato {

/// Learns inputs one after the other with two passes over the weights each: one for the scores, one
/// for the update. For similarities whose winners do not follow from inner products, so that a
/// DenseLearner cannot defer updates, and for inputs with missing elements (NaN), by distances that
/// are sums or maxima over elements. The winner is the one that Som::winner() finds, or the neuron
/// at the least distance by the known elements; only the weights of known elements change (Samad
/// and Harp, "Self-organization with partial data", Network 3, 1992).
class DirectMap : public OnlineMap {
 public:
  DirectMap(Som& som, ThreadTeam& team);

  /// Learns the first input.
  Learned learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) override;
  void settle() override {}
  Som look() override { return som_; }

 private:
  void for_each_part(const std::function<void(std::size_t first, std::size_t blocks)>& work);
  std::size_t winner(std::span<const float> input, const std::vector<KnownRun>& known);
  void move(std::span<const float> input, const std::vector<KnownRun>& known, double learning_rate);

  Som& som_;
  ThreadTeam& team_;
  Neighbourhood neighbourhood_;
  SomWorkspace workspace_;
  AlignedVector<float> neighbours_;
  AlignedVector<float> gains_;
  std::size_t learned_since_clearing_ = 0;
};

}  // namespace somato
