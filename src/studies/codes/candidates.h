#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "studies/codes/codes.h"
#include "studies/codes/mutual_prediction.h"

namespace somato {

/// A code in a scaling, with the nearest neighbours of all explorations.
struct CandidateCode {
  std::size_t source = 0;  ///< In the group.
  Code code;               ///< Not scaled.
  Scaling scaling = Scaling::kNone;
  std::size_t elements = 0;
  double spread = 0.0;
  PerView<std::vector<std::uint32_t>> nearest;
  double stability = 1.0;  ///< The mean imbalance over kSplits with which it predicts itself.
  std::string failure;     ///< The reason if it cannot be used; else empty.

  bool is_usable() const { return failure.empty(); }
};

/// The codes of a sense, or the product of two.
struct CandidateGroup {
  std::vector<std::size_t> senses;
  std::vector<FrameSource> sources;
  std::vector<CandidateCode> candidates;
  /// In which each code is compared.
  std::vector<Scaling> scalings{std::begin(kAllScalings), std::end(kAllScalings)};
};

/// Resources for the comparison of candidates.
struct ComparisonLimits {
  std::size_t elements = 0;  ///< The maximum length of a vector.
  std::size_t threads = 1;
  std::function<Result<void>(double share)> proceed;  ///< Called with the share that is done.
};

/// Compares all codes of a sense, given its sources, and returns its neighbourhoods. Codes that
/// cannot be evaluated, are the same for all explorations, or have too many elements are kept with
/// their failure. Errors: those of the sources' modules and of `proceed`.
Result<Neighbourhoods> compare_codes(const Recording& recording, CandidateGroup& group,
                                     bool has_speed, const ComparisonLimits& limits);

/// The standardized code that keeps the readings as they are: the bands of a sound, ten points of
/// an exploration of several frames, or the only frame; nothing if it cannot be used.
std::optional<std::size_t> plain_code(std::span<const CandidateCode> candidates);

/// Compares the product of two senses, given its source.
Result<void> compare_product(const Recording& recording, CandidateGroup& group,
                             const ComparisonLimits& limits);

/// The distances of chosen candidates of the group, Euclidean or Manhattan.
Result<std::vector<Part>> parts_of(const Recording& recording, const CandidateGroup& group,
                                   std::span<const std::size_t> chosen,
                                   const ComparisonLimits& limits,
                                   Similarity similarity = Similarity::kEuclidean);

/// The vectors of a candidate of the group for whole explorations.
Result<Samples> vectors_of(const Recording& recording, const CandidateGroup& group,
                           std::size_t number, const ComparisonLimits& limits);

}  // namespace somato
