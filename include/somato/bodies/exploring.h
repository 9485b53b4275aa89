#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The number of explorations of each thing, and the number of threads.
struct ExploringPlan {
  std::size_t items = 0;
  std::size_t explorations_each = 5;
  std::size_t threads = 1;
};

/// Explores an item (counting from 0) in the given trial (from 0). Called from several threads at
/// once; must depend only on its arguments.
using Explore = std::function<Result<Exploration>(std::size_t item, std::size_t trial)>;

/// Receives an exploration, for example to write a recording; called by one thread at a time.
using ExplorationSink = std::function<Result<void>(Exploration&&)>;

/// An exploration that ended with an error; its data are discarded.
struct FailedExploration {
  std::size_t item = 0;
  std::size_t trial = 0;
  Error error;
};

/// The outcome of exploring many items.
struct ExploringOutcome {
  std::size_t recorded = 0;                 ///< Number of explorations passed to the sink.
  std::vector<FailedExploration> failures;  ///< In order.
};

/// Explores all items, each for all its trials before the next. Explorations run in parallel, but
/// are passed to `sink` in this order for any number of threads; the number of explorations ahead
/// of it is at most twice the number of threads. A failing exploration is left out and listed; if
/// the body is unavailable (kUnavailable), it is the last one.
/// `progress` is called before the first and after each, completed or failed, in order. Errors:
/// those of the sink, and kInterrupted if `progress` requests to stop or an exploration ends in
/// this way. No more are begun then, and the sink has received all preceding ones. An exception of
/// `explore`, `sink` or `progress` is rethrown in the same way.
Result<ExploringOutcome> explore_all(const ExploringPlan& plan, const Explore& explore,
                                     const ExplorationSink& sink, const Progress& progress = {});

}  // namespace somato
