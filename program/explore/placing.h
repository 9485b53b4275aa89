#pragma once

#include <cstddef>

#include "somato/bodies/explorer.h"
#include "somato/core/result.h"

namespace somato::program {

/// Waits for the key Enter. Errors (kInterrupted): the program is to stop, or the input has ended.
Result<void> wait_for_enter();

/// Requests a person to place a thing, and waits for the key Enter. Errors: those of
/// wait_for_enter().
Result<void> place_by_person(const ExploredThing& thing, std::size_t trial);

/// Reports the fault that has stopped a device, and waits for the key Enter before it moves again.
/// Errors: those of place_by_person(); kUnavailable: the input is not a terminal.
Result<void> permit_by_person(const Error& fault);

}  // namespace somato::program
