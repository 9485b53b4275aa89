#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

namespace somato::live {

/// Tasks of other threads for one thread, and that thread's waiting for them.
class TaskQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using Task = std::function<void()>;

  /// Why a wait has ended.
  enum class Woken { kTask, kTime, kClosed };

  /// From any thread. Returns whether it will be done: not once the queue is closed.
  bool post(Task task);

  /// From any thread: later tasks are not run, and no thread waits for them.
  void close();

  /// Waits for a task and does it, until the queue is closed, or that moment; for ever without one.
  Woken wait(std::optional<Clock::time_point> until);

 private:
  std::mutex mutex_;
  std::condition_variable woken_;
  std::deque<Task> tasks_;
  bool closed_ = false;
};

}  // namespace somato::live
