#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/kernels/t_mpsom_kernels.h"
#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// Trains a T-MPSOM with one input after the other: the same bits as TMpsom::learn(), but faster.
/// An update is deferred until the next input, so that one pass over the weights updates them,
/// computes their response to that input, and computes the terms for the length after the next
/// update. Inputs of more than kernels::kChunk elements are learned immediately.
///
/// The map is only up to date after settle() or after the learner is destroyed, and must not be
/// used elsewhere before.
class TMpsomLearner {
 public:
  explicit TMpsomLearner(TMpsom& map);

  TMpsomLearner(const TMpsomLearner&) = delete;
  TMpsomLearner(TMpsomLearner&&) = delete;
  TMpsomLearner& operator=(const TMpsomLearner&) = delete;
  TMpsomLearner& operator=(TMpsomLearner&&) = delete;

  /// Settles.
  ~TMpsomLearner() { settle(); }

  /// As TMpsom's, for the map with everything learned so far. Learning the last input has almost no
  /// cost.
  void activation(std::span<const SignalView> inputs, std::span<float> out);
  bool learn(std::span<const SignalView> inputs, double alpha);

  /// Makes what was learned visible in the map.
  void settle();

 private:
  // The values known for one input: one for each padded neuron, except for the samples.
  struct Part {
    Part(std::size_t elements, std::size_t padded_neurons, std::size_t groups);
    kernels::Moves moves(std::size_t neuron);
    kernels::Measures measures(std::size_t neuron, std::span<float> partial);

    std::vector<float> receptive;  // the present sample
    std::vector<float> sample;     // towards which moves are put off
    AlignedVector<float> keep;
    AlignedVector<float> add;
    AlignedVector<float> doubtful;
    AlignedVector<float> products;
    AlignedVector<float> squares;
    std::vector<bool> waits;  // whether a group's move does
  };

  void find_activity(std::span<const SignalView> inputs);
  void pass(std::size_t input);
  void put_off(std::size_t input);
  bool find_moves(std::size_t input, std::size_t group);

  TMpsom& map_;
  TMpsom::Workspace workspace_;
  bool puts_off_;
  std::vector<Part> parts_;
};

}  // namespace somato
