#pragma once

#include <span>

#include "somato/suggestion/suggestion.h"
#include "suggestion/candidates.h"

namespace somato {

/// The system of the suggestion's parts: their modules, scaled and concatenated, and a map.
/// `groups` are those of the suggestion.
SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups);

}  // namespace somato
