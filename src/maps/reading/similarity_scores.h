#pragma once

#include <cstddef>
#include <span>

#include "base/kernels/kernels.h"
#include "somato/core/matrix.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The scores of all neurons by a distance that does not follow_from_products(), the least one for
/// the most similar neuron: the Manhattan or Chebyshev distance |x - w|, or the cosine score -(x .
/// w) / |w|, which orders neurons as the cosine distance does; it is 0 for weights that are all 0.
///
/// Single precision selects candidates: two scores are in the right order if they differ by more
/// than score_margin(). exact_score() decides.
class SimilarityScores {
 public:
  /// For the first `rows` rows of `weights`, which must not change while this object is used.
  SimilarityScores(Similarity similarity, kernels::Lanes<const float> weights, std::size_t rows);

  /// Writes the scores for each input to the place of `out` with the same number; each place is
  /// aligned and has a value for each padded row.
  void write(std::span<const float* const> inputs, std::span<float* const> out) const;

  /// The same for some blocks of rows; the other places keep their values.
  void write(std::span<const float* const> inputs, std::span<float* const> out,
             std::size_t first_block, std::size_t blocks) const;

 private:
  void find_lengths();
  void divide_by_lengths(const float* input, std::size_t begin, std::size_t end,
                         float* scores) const;
  float exact_cosine(const float* input, std::size_t row) const;

  Similarity similarity_;
  kernels::Lanes<const float> weights_;
  std::size_t rows_;
  AlignedVector<float> inverse_lengths_;  // of weights, by row; 0: outside the range of `float`
};

/// The score in double precision by any similarity: the squared Euclidean distance, the negative
/// inner product, or a score of SimilarityScores.
double exact_score(Similarity similarity, const float* weights, const float* input,
                   std::size_t count);

/// By how much the single-precision score of the neuron with the least exact score exceeds the
/// least single-precision one, `least`, at most. By a similarity of SimilarityScores.
double score_margin(Similarity similarity, double least, std::span<const float> input);

/// Converts scores of SimilarityScores for one input to distances. `left_out` counts elements of
/// the input for which all weights are 0: the sum of their magnitudes for the Manhattan distance,
/// that of their squares for the others.
class DistanceOfScore {
 public:
  DistanceOfScore(Similarity similarity, std::span<const float> input, double left_out = 0.0);

  double operator()(double score) const;

 private:
  Similarity similarity_;
  double left_out_;
  double length_ = 0.0;  // of the input
};

/// The distance of two vectors by any similarity, in double precision: the cosine distance is 1 -
/// (a . b) / (|a| |b|), and 1 if one of them is 0; maps by inner products have the Euclidean
/// distance. `left_out` counts elements of `b` as above.
double distance_between(Similarity similarity, std::span<const float> a, std::span<const float> b,
                        double left_out = 0.0);

}  // namespace somato
