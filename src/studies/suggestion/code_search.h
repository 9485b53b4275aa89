#pragma once

#include "somato/core/result.h"
#include "studies/suggestion/suggestion_state.h"

namespace somato {

/// Compares the codes of all channels and of products of two, with which it fills the groups of the
/// state; those of its suggestion have their roles and scores. Errors as of suggest().
Result<void> search_codes(SuggestionState& state);

}  // namespace somato
