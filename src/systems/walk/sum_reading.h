#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "somato/codes/normalization.h"
#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

/// The winner of a map for a sum of sparse frames, divided by its norm, without putting the sum
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

  /// Som::winner() for the sum in single precision, divided by its norm; nothing where another
  /// neuron is so close that the rounding of the sum could decide.
  std::optional<std::size_t> winner() const;

 private:
  void add_element(std::size_t element, double value);
  double factor() const;
  double margin(double factor) const;

  const Som& som_;
  Norm norm_;
  Matrix<float> weights_;                // stored elements x neurons
  std::vector<double> squared_lengths_;  // of the neurons' weights
  double greatest_length_ = 0.0;         // of them
  std::vector<std::uint32_t> places_;    // of each element among the stored ones, or their number
  std::vector<double> sums_;             // of each element
  std::vector<double> products_;         // of the sum with each neuron's weights
  double squared_length_ = 0.0;          // of the sum
  double magnitude_ = 0.0;               // of its elements, added up
};

}  // namespace somato
