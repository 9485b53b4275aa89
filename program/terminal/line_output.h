#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato::program {

/// Writes whole lines to standard output, each at once, for programs that read along.
class LineOutput {
 public:
  /// A reader that closes the output is not an error of the system from now on (SIGPIPE).
  LineOutput();

  /// Waits until the reader takes the line. Errors: kInterrupted if a stop is requested while it
  /// waits, and if the output was closed, so that is_closed() holds; kSystem with the system's
  /// reason.
  Result<void> write(const std::string& line);

  /// Whether the reader has closed the output.
  bool is_closed() const { return is_closed_; }

 private:
  Result<void> wait_for_room();
  tl::unexpected<Error> failure();

  bool is_closed_ = false;
};

}  // namespace somato::program
