#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/t_mpsom_kernels.h"
#include "somato/core/lane_matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// Trains a T-MPSOM with one input after the other: the same bits as TMpsom::learn(), faster. A
/// move is put off until the next input has come, so that one pass over the weights moves them,
/// finds what they make of that input, and measures what the length after the next move follows
/// from. Inputs of more than kernels::kChunk elements are learned at once.
///
/// The map has what was learned after settle() or once the learner is gone, not before; nobody else
/// may use it in the meantime.
class TMpsomLearner {
 public:
  explicit TMpsomLearner(TMpsom& map);

  TMpsomLearner(const TMpsomLearner&) = delete;
  TMpsomLearner(TMpsomLearner&&) = delete;
  TMpsomLearner& operator=(const TMpsomLearner&) = delete;
  TMpsomLearner& operator=(TMpsomLearner&&) = delete;

  /// Settles.
  ~TMpsomLearner() { settle(); }

  /// As TMpsom's, of the map with everything learned so far. What was heard last costs next to
  /// nothing to learn.
  void activation(std::span<const SignalView> inputs, std::span<float> out);
  bool learn(std::span<const SignalView> inputs, double alpha);

  /// Makes what was learned visible in the map.
  void settle();

 private:
  // What is known of one input: values of a padded neuron each, but for the samples.
  struct Part {
    Part(std::size_t elements, std::size_t padded_neurons, std::size_t groups);
    kernels::Moves moves(std::size_t neuron);
    kernels::Measures measures(std::size_t neuron, std::span<float> partial);

    std::vector<float> heard;   // the present sample
    std::vector<float> sample;  // towards which moves are put off
    AlignedVector<float> keep;
    AlignedVector<float> add;
    AlignedVector<float> doubtful;
    AlignedVector<float> products;
    AlignedVector<float> squares;
    std::vector<bool> waits;  // whether a group's move does
  };

  void hear(std::span<const SignalView> inputs);
  void pass(std::size_t input);
  void put_off(std::size_t input);
  bool find_moves(std::size_t input, std::size_t group);
  void move_doubtful_rows(std::size_t input, std::size_t group);

  TMpsom& map_;
  TMpsom::Workspace workspace_;
  bool puts_off_;
  std::vector<Part> parts_;
};

}  // namespace somato
