#pragma once

#include <algorithm>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "somato/core/process_group.h"

namespace somato::testing {

/// The memory that the members of a ThreadGroup share.
struct SharedByThreads {
  explicit SharedByThreads(std::size_t size)
      : barrier(static_cast<std::ptrdiff_t>(size)), integers(size), numbers(size), bytes(size) {}

  std::barrier<> barrier;
  std::vector<std::vector<std::int64_t>> integers;
  std::vector<std::vector<double>> numbers;
  std::vector<std::vector<char>> bytes;
};

/// A slow and obvious group of "processes", which are threads.
class ThreadGroup final : public ProcessGroup {
 public:
  ThreadGroup(SharedByThreads& shared, std::size_t rank) : shared_(shared), rank_(rank) {}

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return shared_.integers.size(); }

  void sum(std::span<std::int64_t> values) override {
    exchange(values, shared_.integers, [](std::int64_t a, std::int64_t b) {
      return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                       static_cast<std::uint64_t>(b));
    });
  }
  void maximize(std::span<double> values) override {
    exchange(values, shared_.numbers, [](double a, double b) { return std::max(a, b); });
  }

  void bring_to_first(std::size_t process, std::span<char> values) override {
    shared_.bytes[rank_].assign(values.begin(), values.end());
    shared_.barrier.arrive_and_wait();
    if (rank_ == 0) std::copy_n(shared_.bytes[process].begin(), values.size(), values.begin());
    shared_.barrier.arrive_and_wait();
  }

 private:
  template <typename T, typename Combine>
  void exchange(std::span<T> values, std::vector<std::vector<T>>& all, const Combine& combine) {
    all[rank_].assign(values.begin(), values.end());
    shared_.barrier.arrive_and_wait();
    std::vector<T> combined = all.front();
    for (std::size_t other = 1; other < all.size(); ++other) {
      std::transform(combined.begin(), combined.end(), all[other].begin(), combined.begin(),
                     combine);
    }
    shared_.barrier.arrive_and_wait();
    std::copy(combined.begin(), combined.end(), values.begin());
  }

  SharedByThreads& shared_;
  std::size_t rank_;
};

/// Runs `work` in each member of a group of `size` at the same time.
inline void in_thread_group(std::size_t size, const std::function<void(ProcessGroup&)>& work) {
  SharedByThreads shared(size);
  std::vector<std::jthread> threads;
  threads.reserve(size);
  for (std::size_t rank = 0; rank < size; ++rank) {
    threads.emplace_back([&shared, &work, rank] {
      ThreadGroup group(shared, rank);
      work(group);
    });
  }
}

}  // namespace somato::testing
