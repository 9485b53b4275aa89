#pragma once

#include <span>

#include "suggestion/candidates.h"
#include "suggestion/suggestion.h"

namespace somato {

/// The system of the suggestion's parts: their modules, scaled and concatenated, and a map.
/// `groups` are those of the suggestion.
SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups);

}  // namespace somato
