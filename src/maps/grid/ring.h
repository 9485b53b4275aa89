#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// The highest rank correlations of numbers and places in a ring, over all cuts.
struct RingOrder {
  double growing = 0.0;  ///< With growing angles.
  double falling = 0.0;  ///< With falling ones.
};

/// How many individuals must be taken away until the numbers of the others do not fall around the
/// ring, from the best start.
struct RingExceptions {
  std::size_t growing = 0;  ///< With growing angles.
  std::size_t falling = 0;  ///< With falling ones.
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

  /// For the individuals' numbers, or their ranks. Of those at one angle only individuals with
  /// equal numbers are in order; those at the centre have no angle and are exceptions.
  RingExceptions least_exceptions(const std::vector<double>& numbers) const;

 private:
  std::size_t longest_run(const std::vector<double>& numbers) const;

  std::vector<std::vector<std::size_t>> angles_;  // the individuals at each, by ascending angle
  std::vector<std::vector<double>> cuts_;  // centred ranks of the places, for each first angle
};

}  // namespace somato
