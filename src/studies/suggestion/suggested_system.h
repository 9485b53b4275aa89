#pragma once

#include <span>

#include "studies/suggestion/candidates.h"
#include "studies/suggestion/suggestion.h"

namespace somato {

/// The system of the suggestion's parts: their modules, scaled and concatenated, and a map.
/// `groups` are those of the suggestion.
SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups);

}  // namespace somato
