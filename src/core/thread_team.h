#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace somato {

class FirstException;

/// Threads for jobs of a few microseconds that come one after the other: between two jobs the
/// members wait, first awake, then asleep. The first job worth sharing starts them.
///
/// Each member has tasks of its own, the same ones in each job of as many, so that what they work
/// on stays in the caches of its core. One that has done its own takes over those that others have
/// not begun; nobody waits for a member that is asleep or whose core is busy, only for tasks begun.
class ThreadTeam {
 public:
  /// The order in which a member takes its tasks. Going up and down in turn, it finds in the caches
  /// what it used last.
  enum class Order : std::uint8_t { kUp, kDown };

  /// With the calling thread it has `threads` members; at least 1.
  explicit ThreadTeam(std::size_t threads);

  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam(ThreadTeam&&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ThreadTeam& operator=(ThreadTeam&&) = delete;

  /// No job may be under way.
  ~ThreadTeam();

  std::size_t size() const { return parts_.size(); }

  /// Calls `work(task)` for 0 .. count-1, and returns when all are done. An exception of any task
  /// is rethrown then; tasks not yet begun are left out. While a job is under way, others (of its
  /// own tasks, or of other threads) are done by their calling thread alone.
  void for_each(std::size_t count, const std::function<void(std::size_t task)>& work,
                Order order = Order::kUp);

 private:
  // The tasks of one member, on a cache line of its own.
  struct alignas(64) Part {
    std::atomic<std::size_t> begun = 0;
    std::atomic<bool> attended = false;  // by the member whose tasks they are
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  void start();
  void open(std::size_t count, const std::function<void(std::size_t)>& work, Order order,
            FirstException& exception);
  void close();
  void help(std::size_t member);
  bool enter(std::uint32_t& seen);
  void leave();
  void work_from(std::size_t member);
  void take_over(Part& part, std::chrono::nanoseconds patience);
  bool work_on(Part& part);

  // A job's number, whether it is open, whether the team ends, how many helpers are in the job.
  alignas(64) std::atomic<std::uint32_t> state_ = 0;
  std::atomic<bool> caller_sleeps_ = false;
  alignas(64) std::atomic<bool> busy_ = false;
  const std::function<void(std::size_t)>* work_ = nullptr;
  Order order_ = Order::kUp;
  FirstException* exception_ = nullptr;
  std::vector<Part> parts_;  // a member
  std::vector<std::jthread> helpers_;
};

}  // namespace somato
