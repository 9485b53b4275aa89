#include "base/core/threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace somato {
namespace {

TEST(Threads, OfTheMachineAreAtLeastOne) {
  EXPECT_GE(available_threads(), 1U);
}

TEST(ThreadRanges, CoverEveryIndexOnceInPartsOfNearlyEqualLength) {
  for (std::size_t count = 0; count < 20; ++count) {
    for (std::size_t threads = 0; threads < 6; ++threads) {
      std::vector<int> visits(count);
      std::mutex mutex;
      std::vector<std::size_t> lengths;
      for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
        const std::scoped_lock lock(mutex);
        lengths.push_back(end - begin);
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
      EXPECT_LE(lengths.size(), std::max<std::size_t>(1, threads));
      const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
      EXPECT_LE(*longest - *shortest, 1U);
    }
  }
}

TEST(ThreadRanges, RunOnThreadsOfTheirOwn) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  for_each_range(4, 4, [&](std::size_t, std::size_t) {
    const std::scoped_lock lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen.size(), 4U);
}

TEST(ThreadRanges, RethrowAfterAllAreDone) {
  for (std::size_t failing = 0; failing < 3; ++failing) {
    std::atomic<int> done = 0;
    EXPECT_THROW(for_each_range(3, 3,
                                [&](std::size_t begin, std::size_t) {
                                  if (begin == failing) throw std::runtime_error("failed");
                                  ++done;
                                }),
                 std::runtime_error);
    EXPECT_EQ(done, 2);
  }
}

TEST(ThreadTasks, RunOnceEach) {
  for (std::size_t threads = 0; threads < 6; ++threads) {
    std::vector<int> visits(1000);
    for_each_task(visits.size(), threads, [&](std::size_t index) { ++visits[index]; });
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
  }
}

TEST(ThreadTasks, OfNumberZeroDoNothing) {
  for_each_task(0, 4, [](std::size_t) { FAIL() << "there was no task"; });
}

TEST(ThreadTasks, AreLeftOutAfterAnException) {
  std::vector<int> visits(100);
  EXPECT_THROW(for_each_task(visits.size(), 1,
                             [&](std::size_t index) {
                               ++visits[index];
                               if (index == 3) throw std::runtime_error("failed");
                             }),
               std::runtime_error);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 4);
}

TEST(ThreadTasks, RethrowFromAnyThread) {
  EXPECT_THROW(for_each_task(100, 4, [](std::size_t) { throw std::runtime_error("failed"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace somato
