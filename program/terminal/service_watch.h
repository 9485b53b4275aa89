#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "terminal/service_manager.h"

namespace somato::program {

/// Says to the service manager that a session runs, and repeatedly that its thread responds: one
/// that hangs is started again.
class ServiceWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// Has the thread of the session do a task when it is free; returns whether it will be done.
  using Post = std::function<bool(std::function<void()> task)>;

  ServiceWatch(ServiceManager manager, Post post)
      : manager_(std::move(manager)), post_(std::move(post)) {}

  /// The session has begun. Errors: those of ServiceManager::notify().
  Result<void> begin() const { return manager_.notify("READY=1"); }

  /// To be called often: a response is reported to the manager, and the next one is required after
  /// a quarter of its patience. A message that cannot be sent is reported once, on standard error.
  void look(Clock::time_point now);

  /// The session ends from now on.
  void end() const;

 private:
  void ask(Clock::time_point now);

  ServiceManager manager_;
  Post post_;
  std::shared_ptr<std::atomic<bool>> responded_;  // Or nothing, if nothing was required yet.
  std::optional<Clock::time_point> next_;
  bool is_reported_ = false;
};

}  // namespace somato::program
