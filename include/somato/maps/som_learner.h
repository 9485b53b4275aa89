#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

class OnlineMap;
class ThreadTeam;
struct Learned;
struct OnlineInput;

/// Settings of one learning step.
struct LearningStep {
  double learning_rate = 0.0;
  double radius = 0.0;
};

/// Online training for samples that arrive one at a time. It refers to the map that it trains,
/// which gets weights for the elements of the inputs, or for all elements.
///
/// The map is only up to date after settle() or after the learner is destroyed, and must not be
/// changed by others before. Settling rarely is faster, because a learner defers updates. The same
/// inputs, settled at the same times, give the same bits for every number of threads and
/// instruction set; settling at other times changes roundings.
///
/// If less than a sixteenth of the elements of the first input are non-zero, inputs are learned in
/// separate memory of the size of these elements' weights, until an input has more non-zero
/// elements; unless the map is settled after nearly every input, the computing time then only
/// depends on the non-zero elements. Otherwise, a Euclidean map requires half as much memory again,
/// for a copy of its weights as 16-bit integers: a neuron's score is computed from these, and from
/// the weights if it is so close to another score that rounding could decide. Samples whose inner
/// products the map has (Som::knows()) are learned with them, without weights.
class SomLearner {
 public:
  /// `threads` share each input of a large map; threads other than the calling one exist during the
  /// lifetime of the learner. With `incomplete`, elements of dense inputs may be missing (NaN):
  /// they are left out of distances, and their weights do not change (TrainingOptions::incomplete).
  explicit SomLearner(Som& som, std::size_t threads = 1, bool incomplete = false);

  SomLearner(const SomLearner&) = delete;
  SomLearner(SomLearner&&) = delete;
  SomLearner& operator=(const SomLearner&) = delete;
  SomLearner& operator=(SomLearner&&) = delete;

  /// Settles.
  ~SomLearner();

  /// Finds the winner of `input` and updates the weights: w += learning_rate h (input - w), with
  /// the neighbourhood function h around the winner, followed by scaling to length 1 for a
  /// dot-product map (P11 III). Returns the winner.
  std::size_t learn(const SignalView& input, double learning_rate, double radius);

  /// Learns `inputs` in order, with the same bits as individual calls, but faster; `steps` has one
  /// step for each.
  void learn(std::span<const SignalView> inputs, std::span<const LearningStep> steps);

  /// The same for the samples with these numbers; throws InvalidArgument for a number without a
  /// sample.
  void learn(const Samples& samples, std::span<const std::size_t> numbers,
             std::span<const LearningStep> steps);

  /// As Som::activity() for samples[sample], including everything learned so far; settles the map
  /// unless it knows the samples.
  void activity(const Samples& samples, std::size_t sample, std::span<float> out);

  /// Applies all deferred updates to the map.
  void settle();

  /// A copy of the map as settle() would leave it. Learning continues with the same bits as without
  /// this call.
  Som look() const;

 private:
  enum class Form { kNone, kProducts, kSparse, kDense };
  Form form_for(const OnlineInput& input) const;
  OnlineMap& map_for(const OnlineInput& input);
  void begin(Form form);
  bool learns_directly() const;
  Learned learn_first(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps);
  void learn_all(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps);

  Som& som_;
  bool incomplete_;
  std::unique_ptr<ThreadTeam> team_;
  SomWorkspace workspace_;
  Form form_ = Form::kNone;
  std::unique_ptr<OnlineMap> map_;
  bool read_often_ = false;
  std::size_t learned_since_settled_ = 0;
};

}  // namespace somato
