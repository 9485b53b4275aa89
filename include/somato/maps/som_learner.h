#pragma once

#include <cstddef>
#include <cstdint>

#include "somato/core/lane_matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/neighbourhood.h"
#include "somato/maps/som.h"

namespace somato {

/// One sample at a time, for training while samples come in. Refers to the map it trains, which
/// gets weights for all elements as soon as an input needs one that it has not.
class SomLearner {
 public:
  explicit SomLearner(Som& som);

  /// Finds the winner of `input` and moves the weights towards it:
  /// w += learning_rate h (input - w), with h the neighbourhood function around the winner, then
  /// scaled to length 1 for a dot-product map (P11 III). Returns the winner.
  std::size_t learn(const SignalView& input, double learning_rate, double radius);

 private:
  Som& som_;
  SomWorkspace workspace_;
  Neighbourhood neighbourhood_;
  AlignedVector<float> gains_;
  AlignedVector<float> factors_;
  std::uint64_t learned_ = 0;
};

}  // namespace somato
