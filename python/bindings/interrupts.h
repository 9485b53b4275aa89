#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "nanobind/nanobind.h"
#include "somato/core/progress.h"

namespace somato::python {

/// Runs Python's signal handlers, such as that of Ctrl-C, and reports progress, during long work
/// without the lock of the interpreter. Must outlive the work, whose threads may all use it.
class Interrupts {
 public:
  /// `shown` is called with the completed and the total number of steps, or is None.
  explicit Interrupts(nanobind::object shown = nanobind::none()) : shown_(std::move(shown)) {}

  /// Whether the work continues. In the thread that made this object, because Python runs handlers
  /// only in its main thread, runs them if the last time was long ago: taking the lock may last.
  bool proceed();

  /// The same, for work that reports progress, which is shown as often.
  Progress progress() {
    return [this](std::uint64_t done, std::uint64_t total) { return report(done, total); };
  }

  /// Throws the exception of a handler, or of the function that shows the progress, if there was
  /// one.
  void throw_raised();

 private:
  using Clock = std::chrono::steady_clock;
  using Moment = std::atomic<Clock::time_point>;

  static bool is_due(Moment& last);
  bool report(std::uint64_t done, std::uint64_t total);
  template <typename Work>
  void with_lock(const Work& work);

  nanobind::object shown_;
  std::thread::id maker_ = std::this_thread::get_id();
  Moment handled_at_ = Clock::now();
  Moment shown_at_ = Clock::now();
  std::atomic<bool> stopped_ = false;
  std::optional<nanobind::python_error> raised_;  // guarded by the lock of the interpreter
};

/// Does `work`, whose progress the function `progress` shows, without the lock of the interpreter.
/// Throws the exception of a signal's handler, or of `progress`.
void unlocked(const std::function<void(Interrupts&)>& work,
              nanobind::object progress = nanobind::none());

}  // namespace somato::python
