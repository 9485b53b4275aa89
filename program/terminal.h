#pragma once

#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// From now on there is neither progress nor a summary, only what was asked for and errors.
void be_quiet();
bool is_quiet();

/// Prints a summary on standard output, unless quiet.
void print_summary(const std::string& text);

/// Makes a file size limit an error that is reported; without this it ends the process.
void report_file_size_limits();

/// From now on the first Ctrl-C (or a request to terminate) makes stop_requested() true, and says
/// so at a terminal; the second ends the program at once.
void catch_stop_requests();

/// Whether Ctrl-C has been pressed since catch_stop_requests().
bool stop_requested();

/// The signal that requested it; SIGINT where there was none.
int stop_signal();

/// Progress of something called `what` for a person at a terminal: a line on standard error with
/// the share done and the time left. Silent when standard error is no terminal. Either way stop
/// requests are caught from now on, and ask the work to stop.
Progress terminal_progress(std::string what);

}  // namespace somato::program
