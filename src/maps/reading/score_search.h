#pragma once

#include <cstddef>
#include <span>

#include "maps/reading/similarity_scores.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The search for the winners of many samples by distances that do not follow from inner products:
/// scores in single precision of a few samples and a few blocks of neurons at a time, which stay in
/// the nearest caches. Finds what Som::winner() finds. Refers to the map, which must not change
/// meanwhile; several threads may use one object.
class ScoreSearch {
 public:
  explicit ScoreSearch(const Som& som);

  /// Finds the winners of samples begin, begin + 1, ..., one for each place of `found`; with `two`,
  /// the two most similar neurons. The samples are as the map sees them.
  void find(const Samples& seen, std::size_t begin, bool two, std::span<Winners> found) const;

 private:
  const Som& som_;
  SimilarityScores scores_;
};

}  // namespace somato
