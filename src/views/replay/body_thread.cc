#include "views/replay/body_thread.h"

#include <utility>

namespace somato::live {
namespace {

tl::unexpected<Error> stopped_exploring() {
  return fail(ErrorKind::kInterrupted, "exploring was stopped before its end");
}

}  // namespace

void BodyThread::start(Explorer& explorer, std::size_t thing, std::size_t trial,
                       const std::optional<Placement>& placement, std::size_t memory) {
  join();
  stopping_ = going_on_ = false;
  std::packaged_task<Result<Exploration>()> explore(
      [this, &explorer, thing, trial, placement, memory] {
        const ExploreOptions options{
            {.should_continue = [this] { return !is_stopping(); }, .memory = memory},
            placement,
            {[this](const BodyDescription& body, const Scene& scene) { return begin(body, scene); },
             [this](const ExplorationStep& step) { return hand_over(step); }}};
        return explorer.explore(thing, trial, options);
      });
  explored_ = explore.get_future();
  thread_ = std::thread([this, explore = std::move(explore)]() mutable {
    if (events_.on_thread) events_.on_thread();
    explore();
    queue_.post([this] { end(); });
  });
}

void BodyThread::go_on() {
  {
    const std::scoped_lock lock(mutex_);
    going_on_ = true;
  }
  may_go_on_.notify_all();
}

void BodyThread::stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  may_go_on_.notify_all();
}

void BodyThread::join() {
  stop();
  if (thread_.joinable()) thread_.join();
}

bool BodyThread::is_stopping() const {
  const std::scoped_lock lock(mutex_);
  return stopping_;
}

// A task that comes too late is left out.
Result<void> BodyThread::post(TaskQueue::Task task) {
  const bool posted = queue_.post([this, task = std::move(task)] {
    if (!is_stopping()) task();
  });
  return posted ? Result<void>() : stopped_exploring();
}

Result<void> BodyThread::begin(const BodyDescription& body, const Scene& scene) {
  return post([this, body, scene] { events_.on_begin(body, scene); });
}

// The body stands still in here.
Result<void> BodyThread::hand_over(const ExplorationStep& step) {
  const BodyStep taken{step.state, step.poses, step.readings};
  if (auto posted = post([this, taken] { events_.on_step(taken); }); !posted) return posted;
  std::unique_lock lock(mutex_);
  may_go_on_.wait(lock, [this] { return going_on_ || stopping_; });
  going_on_ = false;
  return stopping_ ? stopped_exploring() : Result<void>();
}

void BodyThread::end() {
  thread_.join();
  events_.on_end(std::move(explored_));
}

}  // namespace somato::live
