#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// How well a map stands for samples.
struct SomQuality {
  /// The mean Euclidean distance of a sample, as the map sees it, from its winner's weights.
  double quantization_error = 0.0;

  /// The share of samples whose winner and second winner do not share an edge on the grid (four
  /// edges on a rectangular grid, six on a hexagonal one; Kiviluoto 1996). 0 on a map of one
  /// neuron.
  double topographic_error = 0.0;

  /// Samples won by each neuron.
  std::vector<std::size_t> hits;

  /// The winner of each sample.
  std::vector<std::size_t> winners;
};

/// Measures a map on samples that come in parts: the same figures however they are parted. Refers
/// to the map, which is not to change meanwhile.
class SomQualityMeasurement {
 public:
  explicit SomQualityMeasurement(const Som& som, std::size_t threads = 1);

  /// Takes more samples in; returns their winners.
  std::vector<std::size_t> add(const Samples& samples);

  /// Of the samples so far, without a list of their winners.
  SomQuality quality() const;

 private:
  const Som& som_;
  std::size_t threads_;
  std::size_t samples_ = 0;
  std::size_t torn_ = 0;
  double distances_ = 0.0;
  std::vector<std::size_t> hits_;
};

/// Measures `som` on `samples` (the training samples or others held out): one search a sample, on
/// `threads` threads, the same result for any number. No samples: both errors are 0.
SomQuality measure_quality(const Som& som, const Samples& samples, std::size_t threads = 1);

/// The U-matrix, a value a neuron: the mean Euclidean distance of its weights from those of the
/// neurons that share an edge with it (Ultsch 1990, one value a neuron). 0 for a neuron alone.
std::vector<double> u_matrix(const Som& som);

/// One component plane: the weight of each neuron for input element `element`.
std::vector<double> component_plane(const Som& som, std::size_t element);

}  // namespace somato
