#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/process_group.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// Quality measures of a map for samples.
struct SomQuality {
  /// The mean of Som::distance(): of a sample, after normalization, from its winner's weights.
  double quantization_error = 0.0;

  /// The share of samples whose winner and second winner do not share an edge on the grid (four
  /// edges on a rectangular grid, six on a hexagonal one; Kiviluoto 1996). 0 for a map with one
  /// neuron.
  double topographic_error = 0.0;

  /// Number of samples won by each neuron.
  std::vector<std::size_t> hits;

  /// The winner of each sample.
  std::vector<std::size_t> winners;
};

/// Measures a map on samples that are provided in parts; the division into parts has no effect.
/// Refers to the map, which must not change in the meantime.
class SomQualityMeasurement {
 public:
  /// `keeps`: distances are kept for combine().
  explicit SomQualityMeasurement(const Som& som, std::size_t threads = 1, bool keeps = false);

  /// Adds samples; returns their winners.
  std::vector<std::size_t> add(const Samples& samples);

  /// Takes in the samples of all processes, those of the first process first, with the same bits as
  /// in one process. To be called once, after all samples, which take 8 bytes each until then:
  /// `keeps` must have been set.
  void combine(ProcessGroup& processes);

  /// The measures of the samples so far, without the list of winners.
  SomQuality quality() const;

 private:
  const Som& som_;
  std::size_t threads_;
  std::size_t samples_ = 0;
  std::size_t topographic_errors_ = 0;
  double distances_ = 0.0;
  bool keeps_;
  std::vector<double> kept_;  // distances
  std::vector<std::size_t> hits_;
};

/// Measures `som` on `samples` (training or held-out samples): one search per sample, on `threads`
/// threads, with the same result for any number. Without samples both errors are 0.
SomQuality measure_quality(const Som& som, const Samples& samples, std::size_t threads = 1);

/// The U-matrix, one value per neuron: the mean distance of its weights from those of the neurons
/// that share an edge with it (Ultsch 1990), by the map's similarity as in Som::distance(). 0 for a
/// single neuron.
std::vector<double> u_matrix(const Som& som);

/// The same distances between the weights of connected neurons, in the order of
/// NeuronGraph::edges(); empty for a map on rows and columns.
std::vector<double> edge_distances(const Som& som);

/// The distance between the weights of two neurons, which the U-matrix is a mean of. Throws
/// InvalidArgument if a neuron is not on the map.
double neuron_distance(const Som& som, std::size_t first, std::size_t second);

/// A component plane: the weight of each neuron for input element `element`.
std::vector<double> component_plane(const Som& som, std::size_t element);

}  // namespace somato
