#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/kernels/kernels.h"
#include "somato/core/matrix.h"
#include "somato/maps/som.h"

namespace somato {

/// Neighbouring elements of an input, all of them known.
struct KnownRun {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The runs of elements of `input` that are not missing (NaN), in order.
std::vector<KnownRun> known_runs(std::span<const float> input);

/// Scores of neurons by the known elements of an input: as SimilarityScores writes them, squared
/// distances by a Euclidean map, and the distance of layers.h by a map with layers, in which a
/// layer without a known element does not count. Only for distances that are sums or maxima over
/// elements, unless all elements of the map or layer are known, or none of the layer.
class KnownScores {
 public:
  /// Refers to all of them.
  KnownScores(const SomParameters& parameters, std::span<const float> input,
              const std::vector<KnownRun>& runs)
      : parameters_(parameters), input_(input), runs_(runs) {}

  /// Writes the scores of the first `rows` rows of `weights`, which has all columns, to `out`, with
  /// a value for each padded row.
  void write(kernels::Lanes<const float> weights, std::size_t rows, float* out) const;

  /// The neuron with the least score in double precision, the first in a tie, where `scores` are
  /// those of all neurons in single precision.
  std::size_t winner(const Som& som, std::span<const float> scores) const;

  /// The score in double precision of a neuron with these weights for all elements.
  double exact(std::span<const float> weights) const;

 private:
  void write_similarity(Similarity similarity, const std::vector<KnownRun>& runs,
                        kernels::Lanes<const float> weights, std::size_t rows, float* out) const;
  void add_layer(const Layer& layer, const std::vector<KnownRun>& runs,
                 kernels::Lanes<const float> weights, std::size_t rows, float* out) const;
  std::vector<KnownRun> runs_of(const Layer& layer) const;
  double margin(double least) const;

  const SomParameters& parameters_;
  std::span<const float> input_;
  const std::vector<KnownRun>& runs_;
};

/// score_margin() for a map with layers; with `incomplete`, inputs may have missing elements.
double layered_margin(const SomParameters& parameters, double least, bool incomplete = false);

/// The distance of two vectors by a map's similarity, or by its layers, in double precision; see
/// distance_between() of similarities.
double distance_between(const SomParameters& parameters, std::span<const float> a,
                        std::span<const float> b, double left_out = 0.0);

}  // namespace somato
