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

/// Threads for consecutive jobs of a few microseconds: between two jobs the members wait, first
/// awake, then asleep. The first job worth sharing starts them.
///
/// Each member has fixed tasks, the same ones in each job with the same number of tasks, so that
/// their data remain in the caches of its core. A member that has completed its tasks takes over
/// tasks of others that have not been started; a job only waits for tasks that have been started,
/// not for a member that is asleep or whose core is busy.
class ThreadTeam {
 public:
  /// The order in which a member runs its tasks. By alternating the direction, it finds the most
  /// recent data in the caches.
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

  /// Calls `work(task)` for 0 .. count-1, and returns when all are done. An exception of a task is
  /// then rethrown; tasks that have not been started are omitted. During a job, other jobs (of its
  /// tasks, or of other threads) are run by their calling thread only.
  void for_each(std::size_t count, const std::function<void(std::size_t task)>& work,
                Order order = Order::kUp);

 private:
  // The tasks of one member, on a separate cache line.
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
