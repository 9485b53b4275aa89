#include "somato/bodies/exploring.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "core/threads.h"
#include "somato/core/check.h"

namespace somato {
namespace {

Error interrupted() {
  return {ErrorKind::kInterrupted, "exploring was interrupted", {}, {}};
}

// Completed explorations on their way to the sink in the order of the indices.
class Queue {
 public:
  Queue(const ExploringPlan& plan, const ExplorationSink& sink, const Progress& progress)
      : plan_(plan),
        total_(plan.items * plan.explorations_each),
        ahead_(2 * std::max<std::size_t>(1, plan.threads)),
        sink_(sink),
        progress_(progress) {
    if (!should_continue()) stop(interrupted());
  }

  std::size_t total() const { return total_; }

  // Waits until exploration `index` may begin; false when it shall not. Indices are taken in order,
  // so the next one for the sink is always under way and never waits here.
  bool may_begin(std::size_t index) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || index < next_ + ahead_; });
    return !stopped_;
  }

  void put(std::size_t index, Result<Exploration> explored) {
    const std::scoped_lock lock(mutex_);
    waiting_.emplace(index, std::move(explored));
    while (!stopped_ && !waiting_.empty() && waiting_.begin()->first == next_) {
      Result<Exploration> first = std::move(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      pass_on(std::move(first));
    }
    changed_.notify_all();
  }

  // An exception: no thread may wait for explorations that are not run.
  void give_up() {
    const std::scoped_lock lock(mutex_);
    stop(interrupted());
  }

  Result<ExploringOutcome> outcome() && {
    if (error_) return fail(std::move(*error_));
    return std::move(outcome_);
  }

 private:
  void pass_on(Result<Exploration> explored) {
    if (!explored) {
      if (explored.error().kind == ErrorKind::kInterrupted)
        return stop(std::move(explored.error()));
      stopped_ = explored.error().kind == ErrorKind::kUnavailable;
      outcome_.failures.push_back({next_ / plan_.explorations_each, next_ % plan_.explorations_each,
                                   std::move(explored.error())});
    } else if (auto taken = sink_(std::move(*explored)); !taken) {
      return stop(std::move(taken.error()));
    } else {
      ++outcome_.recorded;
    }
    ++next_;
    if (!should_continue()) stop(interrupted());
  }

  bool should_continue() const { return !progress_ || progress_(next_, total_); }

  void stop(Error error) {
    if (!error_) error_ = std::move(error);
    stopped_ = true;
    changed_.notify_all();
  }

  const ExploringPlan& plan_;
  std::size_t total_;
  std::size_t ahead_;
  const ExplorationSink& sink_;
  const Progress& progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;
  std::map<std::size_t, Result<Exploration>> waiting_;
  ExploringOutcome outcome_;
  std::optional<Error> error_;
  bool stopped_ = false;
};

}  // namespace

Result<ExploringOutcome> explore_all(const ExploringPlan& plan, const Explore& explore,
                                     const ExplorationSink& sink, const Progress& progress) {
  require(explore && sink, "explore_all: both functions are required");
  Queue queue(plan, sink, progress);
  for_each_task(queue.total(), plan.threads, [&](std::size_t index) {
    if (!queue.may_begin(index)) return;
    try {
      queue.put(index, explore(index / plan.explorations_each, index % plan.explorations_each));
    } catch (...) {
      queue.give_up();
      throw;
    }
  });
  return std::move(queue).outcome();
}

}  // namespace somato
