#pragma once

#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// Makes the process ready: a file size limit is reported instead of ending it, and a closed
/// standard stream stays one that fails, so that no other file can take its place.
void prepare_process();

/// Progress of something called `what` for a person at a terminal: a line on standard error with
/// the share done and the time left. Silent when standard error is no terminal. Either way the
/// first Ctrl-C (or a request to terminate) from now on asks the work to stop; the second ends the
/// program at once.
Progress terminal_progress(std::string what);

}  // namespace somato::program
