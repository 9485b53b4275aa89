#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Not in the papers, whose sensors have no offset.
struct TareParameters {
  std::size_t frames = 1;

  static const Declarations<TareParameters>& declarations();
};

/// Subtracts the readings at rest, by which a sensor's zero differs from exploration to
/// exploration, such as that of a magnetic skin. Frame t of an exploration, counted from 1, with
/// N = `frames`, becomes
///
///     y(t) = x(t) - (x(1) + ... + x(k)) / k,   k = min(t, N),
///
/// element by element: within the first N frames the mean is that of the frames so far, so that no
/// output depends on later frames. Sums are in double precision, in the order of the frames.
class Tare {
 public:
  /// Throws InvalidArgument for parameters out of range.
  Tare(std::size_t elements, const TareParameters& parameters);

  /// The next frame, in place. Throws InvalidArgument for another number of elements.
  void step(std::span<float> frame);

 private:
  std::size_t most_;       // frames in the mean
  std::size_t count_ = 0;  // so far
  std::vector<double> sums_;
};

}  // namespace somato
