#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "studies/codes/candidates.h"
#include "studies/codes/mutual_prediction.h"
#include "studies/suggestion/suggestion.h"

namespace somato {

/// The shares of the work that are done after a step, for progress.
inline constexpr double kCodesDone = 0.6;
inline constexpr double kProductsDone = 0.75;
inline constexpr double kPartsDone = 0.85;

/// A suggestion in the making, which the steps of the search share: first the codes
/// (code_search.h), then their combination and the map (vector_choice.h).
struct SuggestionState {
  SuggestionState(const Recording& explored, const SuggestionParameters& settings,
                  const SuggestionOptions& run_options);

  /// Reports this share of the work as done. Errors: kInterrupted.
  Result<void> proceed(double share) const;

  /// For comparisons that are the work between two shares.
  ComparisonLimits limits(double from, double to) const;

  const std::vector<Channel>& channels() const { return recording.explorations.front().channels; }
  std::vector<std::size_t> channels_with(ChannelRole role) const;

  const SuggestionParameters& parameters;
  const SuggestionOptions& options;
  const Recording& whole;
  bool has_frames;                        ///< Whether an exploration has several.
  Recording recording;                    ///< The explorations that are compared, without labels.
  std::vector<CandidateGroup> groups;     ///< Those of all channels, then of products.
  std::vector<Neighbourhoods> predicted;  ///< Those of the kept senses.
  Suggestion suggestion;
};

}  // namespace somato
