#pragma once

#include "somato/core/result.h"
#include "studies/suggestion/suggestion_state.h"

namespace somato {

/// Combines the codes that search_codes() has compared, compares the combination with the plain
/// vector and with another distance, and measures the size of the map. Errors as of suggest().
Result<void> choose_vector(SuggestionState& state);

}  // namespace somato
