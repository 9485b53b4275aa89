#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// One epoch of batch training, whose samples may come in parts: every weight becomes the mean of
/// all samples, each weighted by the neighbourhood function around its winner; a neuron that no
/// winner reaches keeps its weights. However the samples are parted, and whatever the number of
/// threads, the map becomes the same bits. Refers to the map, which changes when it is finished.
class BatchEpoch {
 public:
  BatchEpoch(Som& som, std::size_t threads);

  /// Finds the winners of `samples`, which have non-zeros only where the map has weights (see
  /// Som::store_all()), and takes them into the means. Returns the winners.
  std::vector<std::size_t> add(const Samples& samples);

  /// Moves the weights to the means, with this neighbourhood radius. Nothing comes after it.
  void finish(double radius);

 private:
  void move_to_mean(std::size_t neuron, std::span<const double> gains, std::vector<double>& mean);

  Som& som_;
  std::size_t threads_;
  // By winner: the sum of its samples, in their order, and how many there are.
  Matrix<double> sums_;
  std::vector<double> counts_;
};

/// A whole epoch on `samples`. The map gets weights for all elements when the samples have one that
/// it has not. Returns the samples' winners before the epoch.
std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads);

/// The winner of each sample, computed on `threads` threads.
std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads);

}  // namespace somato
