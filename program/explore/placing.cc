#include "explore/placing.h"

#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

#include "terminal/terminal.h"

namespace somato::program {
namespace {

// On a terminal, a message replaces the line of the progress.
const char* beginning_of_line() {
  return isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
}

}  // namespace

Result<void> wait_for_enter() {
  constexpr int kPollMs = 100;
  for (;;) {
    if (stop_requested()) return fail(ErrorKind::kInterrupted, "exploring was interrupted");
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, kPollMs) <= 0) continue;
    char byte = 0;
    if (::read(STDIN_FILENO, &byte, 1) <= 0) {
      return fail(ErrorKind::kInterrupted, "the input ended before Enter was pressed");
    }
    if (byte == '\n') return {};
  }
}

Result<void> place_by_person(const ExploredThing& thing, std::size_t trial) {
  fmt::print(stderr, "{}Place {} (trial {}), take your hands away, and press Enter.\n",
             beginning_of_line(), thing.name, trial + 1);
  return wait_for_enter();
}

Result<void> permit_by_person(const Error& fault) {
  if (isatty(STDIN_FILENO) != 1) {
    return fail(ErrorKind::kUnavailable,
                "a fault has stopped the device, and there is no terminal at which a person lets "
                "it move again",
                {}, "remove the cause of the fault, and run the command again");
  }
  tcflush(STDIN_FILENO, TCIFLUSH);  // Enter before the fault permits nothing.
  fmt::print(
      stderr,
      "{}somato: {}\nThe device has stopped. Remove the cause, take your hands away, and press "
      "Enter to explore on, or Ctrl-C to end.\n",
      beginning_of_line(), to_string(fault));
  return wait_for_enter();
}

}  // namespace somato::program
