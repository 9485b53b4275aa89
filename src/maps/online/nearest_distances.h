#pragma once

#include <cstddef>
#include <string>

#include "base/archives/archive.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The mean distance of the samples that a map has learned from their nearest neighbours, which
/// gives distances a unit that follows from the data: it is proportional to the samples, and does
/// not change with a constant element. It needs two numbers, however many samples there were.
class NearestDistances {
 public:
  /// Samples of one learning: each adds its distance from the nearest of the others that differs
  /// from it. Of more than kMostQueries samples, so many at equal intervals add theirs. While fewer
  /// than kFewDistances are known, the rows of `kept`, the neurons of the map, are candidates too:
  /// a map that learns single samples has kept those before. Later, a single sample adds nothing:
  /// its distance from a neuron depends on the unit itself.
  /// `similarity` is Euclidean or Manhattan.
  void see(const Samples& samples, const Matrix<float>& kept,
           Similarity similarity = Similarity::kEuclidean);

  static constexpr std::size_t kMostQueries = 1000;
  static constexpr std::size_t kFewDistances = 10;

  /// The mean, above 0; 0 as long as no two samples differed.
  double mean() const { return count_ > 0.0 ? sum_ / count_ : 0.0; }

  void save(Archive& archive, const std::string& name) const;

  /// Errors (kData, at `where`): missing, of another type or size, or impossible.
  Result<void> load(const Archive& archive, const std::string& name, const std::string& where);

  bool operator==(const NearestDistances&) const = default;

 private:
  double sum_ = 0.0;
  double count_ = 0.0;
};

}  // namespace somato
