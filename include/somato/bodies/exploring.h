#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// How often each of several things is explored, and on how many threads.
struct ExploringPlan {
  std::size_t items = 0;
  std::size_t explorations_each = 5;
  std::size_t threads = 1;
};

/// Explores an item (counting from 0) for its so-and-so-manieth time (from 0). Called from several
/// threads at once; must depend on its arguments alone.
using Explore = std::function<Result<Exploration>(std::size_t item, std::size_t trial)>;

/// Takes an exploration, such as a writer of recordings; called by one thread at a time.
using ExplorationSink = std::function<Result<void>(Exploration&&)>;

/// An exploration that ended with an error; nothing of it is kept.
struct FailedExploration {
  std::size_t item = 0;
  std::size_t trial = 0;
  Error error;
};

struct ExploringOutcome {
  std::size_t recorded = 0;                 ///< Explorations handed to the sink.
  std::vector<FailedExploration> failures;  ///< In order.
};

/// Explores all items, each for all its trials before the next. Explorations run at the same time,
/// but go to `sink` in that order, the same for any number of threads; none is begun further ahead
/// of it than twice the number of threads. One that fails is left out and listed. `progress` is
/// called before the first and after each, done or failed, in order.
/// Errors: those of the sink, and kInterrupted when `progress` says stop or an exploration ends so.
/// Then no more are begun, and the sink has got all that came before. An exception of `explore`,
/// `sink` or `progress` is rethrown in the same way.
Result<ExploringOutcome> explore_all(const ExploringPlan& plan, const Explore& explore,
                                     const ExplorationSink& sink, const Progress& progress = {});

}  // namespace somato
