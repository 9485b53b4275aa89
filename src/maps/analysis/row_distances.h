#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The distances between rows of numbers, in the way in which a map measures the distance of a
/// sample from a neuron. Its const functions can be used by several threads.
class RowDistances {
 public:
  /// Between the neurons of a map.
  static RowDistances of_neurons(const Som& som);

  /// Between samples, which are normalized as the map does.
  static RowDistances of_samples(const Som& som, const Samples& samples);

  std::size_t rows() const { return as_neurons_.neurons(); }

  /// Writes the distances of all rows from `row` to `out`, which has rows() values.
  void write_from(std::size_t row, std::span<double> out) const;

 private:
  RowDistances(SomParameters parameters, LaneMatrix<float> rows);

  Som as_neurons_;
};

/// The numbers of the other rows by their distances from `row`, the nearest first; equal distances
/// in the order of the numbers.
std::vector<std::size_t> others_by_distance(const std::vector<double>& distances, std::size_t row);

}  // namespace somato
