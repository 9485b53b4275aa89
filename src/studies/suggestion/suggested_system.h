#pragma once

#include <span>

#include "studies/codes/candidates.h"
#include "studies/suggestion/suggestion.h"

namespace somato {

/// The study of a suggestion leaves out each exploration of at most so many, else one of five
/// folds.
inline constexpr std::size_t kMostLeftOut = 30;
inline constexpr std::size_t kFolds = 5;

/// The number of explorations that a map learns in each fold of that study.
std::size_t learned_in_fold(std::size_t explorations);

/// The rows and the columns of the map: at most `share` neurons for each exploration that it
/// learns, but 50 times the root of their number if that is fewer, because the time grows with the
/// product of both; and at least `least_side` rows.
std::size_t side_of_map(std::size_t explorations, std::size_t least_side, double share);

/// The system of the suggestion's parts: their modules, scaled and concatenated, and a map.
/// `groups` are those of the suggestion.
SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups);

}  // namespace somato
