#include "terminal/line_output.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

#include "terminal/terminal.h"

namespace somato::program {

LineOutput::LineOutput() {
  std::signal(SIGPIPE, SIG_IGN);
}

// A line that has begun is completed.
Result<void> LineOutput::write(const std::string& line) {
  SOMATO_TRY_VOID(wait_for_room());
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, left.data(), left.size());
    if (written < 0 && errno != EINTR) return failure();
    if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

// A pipe with room takes a line of up to PIPE_BUF bytes at once.
Result<void> LineOutput::wait_for_room() {
  constexpr int kPatience = 50;  // ms
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  while (::poll(&output, 1, kPatience) <= 0) {
    if (stop_requested()) return fail(ErrorKind::kInterrupted, "the reader does not take the line");
  }
  return {};
}

tl::unexpected<Error> LineOutput::failure() {
  is_closed_ = errno == EPIPE;
  if (is_closed_) return fail(ErrorKind::kInterrupted, "the output was closed");
  return fail(ErrorKind::kSystem, "cannot write: " + std::generic_category().message(errno),
              "standard output", "free disk space, or write to another place");
}

}  // namespace somato::program
