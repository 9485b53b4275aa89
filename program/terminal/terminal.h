#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// Suppresses progress and summaries from now on; results and errors are still printed.
void be_quiet();
bool is_quiet();

/// Prints a summary on standard output, unless quiet.
void print_summary(const std::string& text);

/// Makes a file size limit an error that is reported; without this it ends the process.
void report_file_size_limits();

/// From now on the first Ctrl-C (or a request to terminate, or the end of the terminal) makes
/// stop_requested() true, with a message on a terminal; the second ends the program immediately.
void catch_stop_requests();

/// Makes `handler` handle the second signal instead, and all signals that end the program after a
/// fault; nullptr: as before. It must end the program.
void on_last_signal(void (*handler)(int));

/// Whether Ctrl-C has been pressed since catch_stop_requests().
bool stop_requested();

/// Counts from now on how often the program is continued after it was stopped, as by Ctrl-Z.
std::function<std::size_t()> count_continuations();

/// The signal that requested it; SIGINT if there was none.
int stop_signal();

/// Makes terminal_progress() write a new line every half minute if standard error is not a
/// terminal.
void log_progress();

/// Progress of the task `what` on a terminal: a line on standard error with the share done and the
/// remaining time. Silent if standard error is not a terminal, unless progress is logged. In all
/// cases stop requests are caught from now on and stop the task.
Progress terminal_progress(std::string what);

}  // namespace somato::program
