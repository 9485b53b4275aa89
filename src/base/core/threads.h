#pragma once

#include <cstddef>
#include <functional>

namespace somato {

/// The number of threads a machine runs at once, at least 1.
std::size_t available_threads();

/// Splits 0 .. count-1 into at most `threads` ranges of nearly equal length and calls
/// `work(begin, end)` for each, one range a thread; returns when all are done. An exception of any
/// range is rethrown. `work` must give the same result however the range is split.
void for_each_range(std::size_t count, std::size_t threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& work);

/// Calls `work(index)` for 0 .. count-1; each thread takes the next index when it is free: for
/// independent tasks of different lengths. An exception is rethrown after all threads have stopped;
/// tasks that have not been started are omitted.
void for_each_task(std::size_t count, std::size_t threads,
                   const std::function<void(std::size_t index)>& work);

}  // namespace somato
