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

/// Calls `work(index)` for 0 .. count-1, each thread taking the next index when it is free: for
/// tasks of unequal length that do not depend on each other. An exception is rethrown once all
/// threads have stopped; the tasks not yet begun are then left out.
void for_each_task(std::size_t count, std::size_t threads,
                   const std::function<void(std::size_t index)>& work);

}  // namespace somato
