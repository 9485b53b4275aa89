#include "somato/bodies/exploring.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/core/threads.h"
#include "somato/core/check.h"

namespace somato {
namespace {

Error interrupted() {
  return {ErrorKind::kInterrupted, "exploring was interrupted", {}, {}};
}

// The explorations of a plan, by their indices.
class Places {
 public:
  Places(const Explorer& explorer, const ExploringPlan& plan)
      : things_(plan.things ? *plan.things : all_of(explorer)),
        each_(plan.explorations_each),
        first_trial_(plan.first_trial) {
    for (const std::size_t thing : things_) {
      require(thing < explorer.things().size(), "explore_all: no such thing");
    }
  }

  std::size_t count() const { return things_.size() * each_; }
  std::size_t thing(std::size_t index) const { return things_[index / each_]; }
  std::size_t trial(std::size_t index) const { return first_trial_ + index % each_; }

 private:
  static std::vector<std::size_t> all_of(const Explorer& explorer) {
    std::vector<std::size_t> things(explorer.things().size());
    std::iota(things.begin(), things.end(), std::size_t{0});
    return things;
  }

  std::vector<std::size_t> things_;
  std::size_t each_;
  std::size_t first_trial_;
};

// Completed explorations on their way to the sink in the order of the indices.
class Queue {
 public:
  Queue(const Places& places, std::size_t threads, const ExplorationSink& sink,
        const Progress& progress)
      : places_(places),
        ahead_(2 * std::max<std::size_t>(1, threads)),
        sink_(sink),
        progress_(progress) {
    if (!should_continue()) stop(interrupted());
  }

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
      outcome_.failures.push_back(
          {places_.thing(next_), places_.trial(next_), std::move(explored.error())});
    } else if (auto taken = sink_(std::move(*explored)); !taken) {
      return stop(std::move(taken.error()));
    } else {
      ++outcome_.recorded;
    }
    ++next_;
    if (!should_continue()) stop(interrupted());
  }

  bool should_continue() const { return !progress_ || progress_(next_, places_.count()); }

  void stop(Error error) {
    if (!error_) error_ = std::move(error);
    stopped_ = true;
    changed_.notify_all();
  }

  const Places& places_;
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

// Several threads may call `explore` if there are several.
template <typename Work>
Result<ExploringOutcome> explore_places(const Places& places, std::size_t threads,
                                        const Work& explore, const ExplorationSink& sink,
                                        const Progress& progress) {
  require(static_cast<bool>(sink), "explore_all: a sink is required");
  Queue queue(places, threads, sink, progress);
  for_each_task(places.count(), threads, [&](std::size_t index) {
    if (!queue.may_begin(index)) return;
    try {
      queue.put(index, explore(places.thing(index), places.trial(index)));
    } catch (...) {
      queue.give_up();
      throw;
    }
  });
  return std::move(queue).outcome();
}

}  // namespace

Result<ExploringOutcome> explore_all(Explorer& explorer, const ExploringPlan& plan,
                                     const ExploreOptions& options, const ExplorationSink& sink,
                                     const Progress& progress) {
  const auto explore = [&](std::size_t thing, std::size_t trial) {
    return explorer.explore(thing, trial, options);
  };
  return explore_in_turn(explorer, plan, explore, sink, progress);
}

Result<ExploringOutcome> explore_in_turn(const Explorer& explorer, const ExploringPlan& plan,
                                         const Explore& explore, const ExplorationSink& sink,
                                         const Progress& progress) {
  require(static_cast<bool>(explore), "explore_in_turn: a function that explores is required");
  return explore_places(Places(explorer, plan), 1, explore, sink, progress);
}

Result<ExploringOutcome> explore_all(const SimulatedExplorer& explorer, const ExploringPlan& plan,
                                     std::size_t threads, const ExploreOptions& options,
                                     const ExplorationSink& sink, const Progress& progress) {
  const auto explore = [&](std::size_t thing, std::size_t trial) {
    return explorer.explore(thing, trial, options);
  };
  return explore_places(Places(explorer, plan), threads, explore, sink, progress);
}

}  // namespace somato
