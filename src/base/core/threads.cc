#include "base/core/threads.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "base/core/first_exception.h"

namespace somato {
namespace {

// Runs work(0) .. work(threads-1), work(0) on the calling thread.
void on_threads(std::size_t threads, const std::function<void(std::size_t)>& work) {
  std::vector<std::jthread> others;
  others.reserve(threads - 1);
  for (std::size_t thread = 1; thread < threads; ++thread) others.emplace_back(work, thread);
  work(0);
}

}  // namespace

std::size_t available_threads() {
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

void for_each_range(std::size_t count, std::size_t threads,
                    const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t parts = std::max<std::size_t>(1, std::min(threads, count));
  FirstException exception;
  on_threads(parts, [&](std::size_t part) {
    exception.guard([&] { work(count * part / parts, count * (part + 1) / parts); });
  });
  exception.rethrow();
}

void for_each_task(std::size_t count, std::size_t threads,
                   const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  FirstException exception;
  on_threads(std::max<std::size_t>(1, std::min(threads, count)), [&](std::size_t) {
    for (std::size_t index = next++; index < count && !exception.caught(); index = next++) {
      exception.guard([&] { work(index); });
    }
  });
  exception.rethrow();
}

}  // namespace somato
