#include "base/core/thread_team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace somato {
namespace {

using Order = ThreadTeam::Order;

TEST(ThreadTeam, DoesEachTaskOnce) {
  for (std::size_t threads = 0; threads < 6; ++threads) {
    ThreadTeam team(threads);
    for (std::size_t count = 0; count < 20; ++count) {
      for (const Order order : {Order::kUp, Order::kDown}) {
        std::vector<int> visits(count);
        team.for_each(count, [&](std::size_t task) { ++visits[task]; }, order);
        EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads;
      }
    }
  }
}

// More jobs than their numbers can distinguish; each job reads what the preceding one has written.
TEST(ThreadTeam, DoesManyShortJobs) {
  for (const auto& [threads, jobs] : {std::pair{2U, 70000}, std::pair{4U, 3000}}) {
    ThreadTeam team(threads);
    std::vector<int> visits(7);
    for (int job = 0; job < jobs; ++job) {
      team.for_each(visits.size(), [&](std::size_t task) { ++visits[task]; });
    }
    EXPECT_EQ(visits, std::vector<int>(7, jobs));
  }
}

TEST(ThreadTeam, GoesBothWays) {
  ThreadTeam team(1);
  std::vector<std::size_t> tasks;
  const auto note = [&](std::size_t task) { tasks.push_back(task); };
  team.for_each(3, note);
  team.for_each(3, note, Order::kDown);
  EXPECT_EQ(tasks, (std::vector<std::size_t>{0, 1, 2, 2, 1, 0}));
}

// Two tasks, of which each ends only when both have begun, need two threads; long pauses put the
// helper to sleep.
TEST(ThreadTeam, WorksOnThreadsThatStay) {
  ThreadTeam team(2);
  std::set<std::thread::id> seen;
  for (int job = 0; job < 20; ++job) {
    std::atomic<int> begun = 0;
    std::vector<std::thread::id> of_task(2);
    team.for_each(2, [&](std::size_t task) {
      of_task[task] = std::this_thread::get_id();
      ++begun;
      while (begun < 2) std::this_thread::yield();
    });
    EXPECT_NE(of_task[0], of_task[1]);
    seen.insert(of_task.begin(), of_task.end());
    if (job % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(seen.size(), 2U);
}

TEST(ThreadTeam, WaitsForTasksBegun) {
  ThreadTeam team(2);
  const std::thread::id caller = std::this_thread::get_id();
  for (int job = 0; job < 10; ++job) {
    std::atomic<int> begun = 0;
    std::atomic<int> done = 0;
    team.for_each(2, [&](std::size_t) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
      if (std::this_thread::get_id() != caller) {
        std::this_thread::sleep_for(std::chrono::microseconds(100 * job));
      }
      ++done;
    });
    EXPECT_EQ(done, 2);
  }
}

TEST(ThreadTeam, RethrowsAndLeavesOutWhatHasNotBegun) {
  for (const std::size_t threads : {1U, 2U, 4U}) {
    ThreadTeam team(threads);
    for (std::size_t failing = 0; failing < 8; ++failing) {
      std::atomic<std::size_t> done = 0;
      EXPECT_THROW(team.for_each(8,
                                 [&](std::size_t task) {
                                   if (task == failing) throw std::runtime_error("failed");
                                   ++done;
                                 }),
                   std::runtime_error);
      EXPECT_LE(done, 7U);
    }
    EXPECT_THROW(team.for_each(8, [](std::size_t) { throw std::runtime_error("each"); }),
                 std::runtime_error);
    std::vector<int> visits(8);
    team.for_each(8, [&](std::size_t task) { ++visits[task]; });
    EXPECT_EQ(visits, std::vector<int>(8, 1));
  }
}

TEST(ThreadTeam, DoesJobsWithinJobs) {
  ThreadTeam team(3);
  std::vector<std::vector<int>> visits(5, std::vector<int>(4));
  team.for_each(5, [&](std::size_t outer) {
    team.for_each(4, [&](std::size_t inner) { ++visits[outer][inner]; });
  });
  EXPECT_EQ(visits, std::vector<std::vector<int>>(5, std::vector<int>(4, 1)));
}

TEST(ThreadTeam, DoesJobsOfSeveralThreads) {
  ThreadTeam team(2);
  std::vector<std::vector<int>> visits(3, std::vector<int>(6));
  {
    std::vector<std::jthread> callers;
    callers.reserve(visits.size());
    for (std::vector<int>& of_caller : visits) {
      callers.emplace_back([&] {
        for (int job = 0; job < 500; ++job) {
          team.for_each(6, [&](std::size_t task) { ++of_caller[task]; });
        }
      });
    }
  }
  EXPECT_EQ(visits, std::vector<std::vector<int>>(3, std::vector<int>(6, 500)));
}

// Before a first job, while its members are awake, and when they are asleep.
TEST(ThreadTeam, EndsWhateverItsMembersDo) {
  for (int i = 0; i < 50; ++i) {
    const ThreadTeam idle(4);
    ThreadTeam awake(4);
    ThreadTeam asleep(4);
    std::atomic<int> done = 0;
    asleep.for_each(4, [&](std::size_t) { ++done; });
    if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    awake.for_each(4, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 8);
  }
}

}  // namespace
}  // namespace somato
