#pragma once

#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// Makes a file size limit an error that is reported; without this it ends the process.
void report_file_size_limits();

/// Whether Ctrl-C has been pressed since a terminal_progress() was made.
bool stop_requested();

/// Progress of something called `what` for a person at a terminal: a line on standard error with
/// the share done and the time left. Silent when standard error is no terminal. Either way the
/// first Ctrl-C (or a request to terminate) from now on asks the work to stop; the second ends the
/// program at once.
Progress terminal_progress(std::string what);

}  // namespace somato::program
