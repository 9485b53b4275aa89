#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

class DenseLearner;
class SparseLearner;
class ThreadTeam;

/// How one input is learned.
struct LearningStep {
  double learning_rate = 0.0;
  double radius = 0.0;
};

/// One sample at a time, for training while samples come in. Refers to the map it trains, which
/// gets weights for the elements that inputs bring, or for all.
///
/// The map has what was learned after settle() or once the learner is gone, not before; nobody else
/// may change it in the meantime. Settling seldom is fast: a learner puts updates off. The same
/// inputs, settled at the same times, give the same bits for every number of threads and
/// instruction set; other times change roundings.
///
/// A stream that begins with an input of which less than a sixteenth of the elements are not 0 is
/// learned in memory of its own, as much again as these elements' weights take, until an input has
/// more; unless the map is settled after nearly each input, only what is not 0 then costs time.
/// Other streams take half as much again on a Euclidean map, for a copy of its weights as 16-bit
/// integers: a neuron's score is computed from these, and from the weights where it is so close to
/// another's that rounding could decide.
class SomLearner {
 public:
  /// `threads` share each input of a map that is large enough; others than the calling one live as
  /// long as the learner.
  explicit SomLearner(Som& som, std::size_t threads = 1);

  SomLearner(const SomLearner&) = delete;
  SomLearner(SomLearner&&) = delete;
  SomLearner& operator=(const SomLearner&) = delete;
  SomLearner& operator=(SomLearner&&) = delete;

  /// Settles.
  ~SomLearner();

  /// Finds the winner of `input` and moves the weights towards it:
  /// w += learning_rate h (input - w), with h the neighbourhood function around the winner, then
  /// scaled to length 1 for a dot-product map (P11 III). Returns the winner.
  std::size_t learn(const SignalView& input, double learning_rate, double radius);

  /// Learns `inputs` one after the other, the same bits faster; `steps` holds one step for each.
  void learn(std::span<const SignalView> inputs, std::span<const LearningStep> steps);

  /// Makes what was learned visible in the map.
  void settle();

 private:
  bool learns_sparsely(const SignalView& input) const;
  std::size_t learn_sparsely(const SignalView& input, const LearningStep& step);
  std::span<const float> seen(const SignalView& input);
  std::size_t learn_ahead(std::span<const SignalView> inputs, std::span<const LearningStep> steps);

  Som& som_;
  std::unique_ptr<ThreadTeam> team_;
  SomWorkspace workspace_;
  std::unique_ptr<DenseLearner> dense_;
  std::unique_ptr<SparseLearner> sparse_;
  std::vector<std::vector<float>> prepared_;
  bool read_often_ = false;
  std::size_t learned_since_settled_ = 0;
};

}  // namespace somato
