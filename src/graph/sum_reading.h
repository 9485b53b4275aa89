#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/codes/normalization.h"
#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

/// What a map says of a sum of sparse frames, divided by its norm, without putting the sum
/// together. The map must outlive it and not change.
class SumReading {
 public:
  /// Whether the norm of a sum can be followed from frame to frame: not that of the largest
  /// element, which may shrink.
  static bool follows(Norm norm);

  /// Throws InvalidArgument for a norm that it does not follow.
  SumReading(const Som& som, Norm norm);

  /// Begins an empty sum.
  void start();

  /// Adds a frame of as many elements as an input of the map has.
  void add(const SignalView& frame);

  /// As Som's for the sum as it is.
  std::size_t winner() const;
  std::size_t winner_among(std::span<const std::size_t> candidates) const;
  double distance(std::size_t neuron) const;
  void activity(std::span<float> out) const;

 private:
  void add_element(std::size_t element, double value);
  double factor() const;
  double squared_distance(std::size_t neuron, double factor) const;
  double score(std::size_t neuron, double factor) const;

  const Som& som_;
  Norm norm_;
  Matrix<float> weights_;                // stored elements x neurons
  std::vector<double> squared_lengths_;  // of the neurons' weights
  std::vector<std::uint32_t> places_;    // of each element among the stored ones, or their number
  std::vector<double> sums_;             // of each element
  std::vector<double> products_;         // of the sum with each neuron's weights
  double squared_length_ = 0.0;          // of the sum
  double magnitude_ = 0.0;               // of its elements, added up
};

}  // namespace somato
