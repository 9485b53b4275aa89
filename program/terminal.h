#pragma once

#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// From now on the first Ctrl-C (or a request to terminate) asks the running work to stop; the
/// second ends the program at once.
void catch_interrupts();

/// Progress of something called `what` for a person at a terminal: a line on standard error with
/// the share done and the time left. Silent when standard error is no terminal. Either way it stops
/// the work after an interrupt.
Progress terminal_progress(std::string what);

}  // namespace somato::program
