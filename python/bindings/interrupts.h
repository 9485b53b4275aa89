#pragma once

#include <chrono>
#include <optional>

#include "nanobind/nanobind.h"
#include "somato/core/progress.h"

namespace somato::python {

/// Runs Python's signal handlers, such as that of Ctrl-C, during long work without the lock of the
/// interpreter. Must outlive the work.
class Interrupts {
 public:
  /// Whether the work continues. Runs the handlers if the last time was long ago, because taking
  /// the lock may last.
  bool proceed();

  /// The same, for work that reports progress.
  Progress progress() {
    return [this](std::uint64_t /*done*/, std::uint64_t /*total*/) { return proceed(); };
  }

  /// Throws the exception of a handler if there was one.
  void throw_raised();

 private:
  std::chrono::steady_clock::time_point checked_ = std::chrono::steady_clock::now();
  std::optional<nanobind::python_error> raised_;
};

}  // namespace somato::python
