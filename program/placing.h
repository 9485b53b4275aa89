#pragma once

#include <cstddef>

#include "somato/bodies/explorer.h"
#include "somato/core/result.h"

namespace somato::program {

/// Requests a person to place a thing, and waits for the key Enter. Errors (kInterrupted): the
/// program is to stop, or the input has ended.
Result<void> place_by_person(const ExploredThing& thing, std::size_t trial);

}  // namespace somato::program
