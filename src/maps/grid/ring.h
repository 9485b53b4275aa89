#pragma once

#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// The highest rank correlations of numbers and places in a ring, over all cuts.
struct RingOrder {
  double growing = 0.0;  ///< With growing angles.
  double falling = 0.0;  ///< With falling ones.
};

/// Individuals around a centre, as a ring that can be divided between any two angles. Their places
/// are ranked once; numbers can then be compared with them repeatedly.
class Ring {
 public:
  /// The positions of the individuals relative to the centre. Angles (and lengths) within 1e-9 are
  /// equal; an individual at the centre gets the middle place.
  explicit Ring(const std::vector<Position>& from_centre);

  /// For the centred ranks of the individuals' numbers; 0 when all are at the centre.
  RingOrder best_order(const std::vector<double>& ranks) const;

 private:
  std::vector<std::vector<double>> cuts_;  // centred ranks of the places, for each first angle
};

}  // namespace somato
