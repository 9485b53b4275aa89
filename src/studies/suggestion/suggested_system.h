#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "studies/codes/candidates.h"
#include "studies/suggestion/suggestion.h"

namespace somato {

/// The study of a suggestion leaves out each exploration of at most so many, else one of five
/// folds.
inline constexpr std::size_t kMostLeftOut = 30;
inline constexpr std::size_t kFolds = 5;

/// The rows and the columns of the map: at most `share` neurons for each exploration, but 50 times
/// the root of their number if that is fewer, because the time grows with the product of both; and
/// at least `least_side` rows and columns.
std::pair<std::size_t, std::size_t> sides_of_map(std::size_t explorations, std::size_t least_side,
                                                 double share);

/// The system of the suggestion's parts: their modules, scaled and concatenated, and a map.
/// `groups` are those of the suggestion.
SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups);

}  // namespace somato
