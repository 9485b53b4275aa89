#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "somato/bodies/explorer.h"
#include "views/replay/task_queue.h"

namespace somato::live {

/// The state and poses after a step of a body; see ExplorationStep.
struct BodyStep {
  BodyState state;
  std::vector<ScenePose> poses;
  Readings readings = Readings::kLeftOut;
};

/// A body that explores in a separate thread. After each step it waits for go_on(): the player
/// pauses it by not calling that.
class BodyThread {
 public:
  /// Called by the thread of the queue, in the order in which it happens, except `on_thread`.
  struct Events {
    std::function<void(const BodyDescription& body, const Scene& scene)> on_begin;
    std::function<void(BodyStep step)> on_step;
    std::function<void(std::future<Result<Exploration>> explored)> on_end;
    std::function<void()> on_thread = {};  ///< Called by the body's thread at its begin; or empty.
  };

  BodyThread(TaskQueue& queue, Events events) : queue_(queue), events_(std::move(events)) {}
  BodyThread(const BodyThread&) = delete;
  BodyThread(BodyThread&&) = delete;
  BodyThread& operator=(const BodyThread&) = delete;
  BodyThread& operator=(BodyThread&&) = delete;
  ~BodyThread() { join(); }

  /// Begins an exploration, of an object placed at random without `placement`, which ends before
  /// the next one begins. `explorer` must outlive it; no other thread may use it meanwhile. The
  /// exploration has no frames at its end if they take more than `memory` bytes.
  void start(Explorer& explorer, std::size_t thing, std::size_t trial,
             const std::optional<Placement>& placement, std::size_t memory);

  /// From start() until `on_end` is called.
  bool is_exploring() const { return thread_.joinable(); }

  /// Lets the body take its next step.
  void go_on();

  /// Has the exploration end soon, with an error of kInterrupted; its steps are of no interest.
  void stop();

  /// The same, and waits for the end; `on_end` is not called.
  void join();

 private:
  bool is_stopping() const;
  Result<void> post(TaskQueue::Task task);
  Result<void> begin(const BodyDescription& body, const Scene& scene);
  Result<void> hand_over(const ExplorationStep& step);
  void end();

  TaskQueue& queue_;
  Events events_;
  std::thread thread_;
  std::future<Result<Exploration>> explored_;
  mutable std::mutex mutex_;
  std::condition_variable may_go_on_;
  bool going_on_ = false;
  bool stopping_ = false;
};

}  // namespace somato::live
