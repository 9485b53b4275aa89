#include "views/replay/task_queue.h"

#include <utility>

namespace somato::live {

bool TaskQueue::post(Task task) {
  {
    const std::scoped_lock lock(mutex_);
    if (closed_) return false;
    tasks_.push_back(std::move(task));
  }
  woken_.notify_one();
  return true;
}

void TaskQueue::close() {
  std::deque<Task> left;
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    left.swap(tasks_);
  }
  woken_.notify_all();
}

TaskQueue::Woken TaskQueue::wait(std::optional<Clock::time_point> until) {
  std::unique_lock lock(mutex_);
  const auto has_cause = [&] { return closed_ || !tasks_.empty(); };
  if (!until) {
    woken_.wait(lock, has_cause);
  } else if (!woken_.wait_until(lock, *until, has_cause)) {
    return Woken::kTime;
  }
  if (closed_) return Woken::kClosed;
  const Task task = std::move(tasks_.front());
  tasks_.pop_front();
  lock.unlock();
  task();
  return Woken::kTask;
}

}  // namespace somato::live
