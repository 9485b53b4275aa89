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

/// Scores of neurons by the known elements of an input, as SimilarityScores writes them; for a
/// Euclidean map squared distances. Only for distances that are sums or maxima over elements,
/// unless all elements are known.
class KnownScores {
 public:
  /// Refers to both.
  KnownScores(std::span<const float> input, const std::vector<KnownRun>& runs)
      : input_(input), runs_(runs) {}

  /// Writes the scores of the first `rows` rows of `weights`, which has all columns, to `out`, with
  /// a value for each padded row.
  void write(Similarity similarity, kernels::Lanes<const float> weights, std::size_t rows,
             float* out) const;

  /// The neuron with the least score in double precision, the first in a tie, where `scores` are
  /// those of all neurons in single precision.
  std::size_t winner(const Som& som, std::span<const float> scores) const;

 private:
  double margin(double least) const;

  std::span<const float> input_;
  const std::vector<KnownRun>& runs_;
};

}  // namespace somato
