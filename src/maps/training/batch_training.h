#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "maps/training/sum_scales.h"
#include "somato/core/matrix.h"
#include "somato/core/process_group.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// One epoch of batch training, whose samples may be provided in parts: every weight becomes the
/// mean of all samples, each weighted by the neighbourhood function around its winner; a neuron
/// without a winner in its neighbourhood (with a weight of 2^-1000 or more) keeps its weights. The
/// sums are those of integers (SumScales), so the map has the same bits for every order of samples,
/// division into parts and number of threads. Refers to the map, which changes at the end.
class BatchEpoch {
 public:
  /// `scales` are those of all samples of the epoch as the map sees them. With `incomplete`,
  /// elements of dense samples may be missing (NaN): the mean of each element is then that of the
  /// samples that know it; without one in its neighbourhood a weight stays as it is.
  BatchEpoch(Som& som, const SumScales& scales, std::size_t threads, bool incomplete = false);

  /// Makes add() measure the distances of samples, of which the longest has this length, from their
  /// winners. To be called before it.
  void measure(double longest);

  /// The mean of these distances of `samples` samples: the same bits for every order of samples.
  double mean_distance(std::size_t samples) const;

  /// Finds the winners of samples as the map sees them (seen_samples()), which have non-zeros only
  /// where the map has weights (see Som::store_all()), and takes them into the means. Returns the
  /// winners.
  std::vector<std::size_t> add(const Samples& seen);

  /// Takes in the samples of all processes. To be called once, after all samples.
  void combine(ProcessGroup& processes);

  /// Moves the weights to the means, with this neighbourhood radius. Nothing comes after it.
  void finish(double radius);

 private:
  class Means;

  void add_block(const Samples& samples, const std::vector<std::size_t>& winners,
                 std::size_t block);
  void add_known(const Samples& samples, const std::vector<std::size_t>& winners,
                 std::size_t block);
  double distance(const SignalView& sample, std::size_t winner, std::vector<float>& row,
                  SomWorkspace& workspace) const;
  void add_distances(const Samples& samples, const std::vector<std::size_t>& winners);
  void move_block(std::size_t block, std::span<const double> sums, std::span<const double> totals);
  void move_known(std::size_t block, std::span<const double> sums, std::span<const double> totals);

  Som& som_;
  std::size_t threads_;
  const SumScales& scales_;
  // Elements and a last row of counts by winner: the sums of its samples.
  LaneMatrix<std::int64_t> sums_;
  LaneMatrix<std::int64_t> known_;  // elements by winner: samples that know it; or empty
  // The sum of distances times a power of 2; without measurement the power is 0.
  double distance_scale_ = 0.0;
  std::int64_t distances_ = 0;
};

/// A whole epoch on `samples`. The map gets weights for all elements when the samples have one that
/// it has not. Returns the samples' winners before the epoch.
std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads);

/// The winner of each sample, computed on `threads` threads.
std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads);

}  // namespace somato
