#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "somato/bodies/explorer.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The things and trials that are explored: each thing for all its trials before the next.
struct ExploringPlan {
  std::size_t explorations_each = 5;
  std::size_t first_trial = 0;
  std::optional<std::vector<std::size_t>> things = {};  ///< By number; by default all.
};

/// Receives an exploration, for example to write a recording; called by one thread at a time.
using ExplorationSink = std::function<Result<void>(Exploration&&)>;

/// An exploration that ended with an error; its data are discarded.
struct FailedExploration {
  std::size_t thing = 0;
  std::size_t trial = 0;
  Error error;
};

/// The outcome of exploring many items.
struct ExploringOutcome {
  std::size_t recorded = 0;                 ///< Number of explorations passed to the sink.
  std::vector<FailedExploration> failures;  ///< In order.
};

/// Explores with any body, one thing after the other, in the calling thread, and passes the
/// explorations to `sink`. A failing exploration is left out and listed; if the body is unavailable
/// (kUnavailable), it is the last one.
/// `progress` is called before the first and after each, completed or failed, in order. Errors:
/// those of the sink, and kInterrupted if `progress` requests to stop or an exploration ends in
/// this way. No more are begun then, and the sink has received all preceding ones. An exception of
/// the explorer, `sink` or `progress` is rethrown in the same way. Throws InvalidArgument without a
/// sink, and for an unknown thing.
Result<ExploringOutcome> explore_all(Explorer& explorer, const ExploringPlan& plan,
                                     const ExploreOptions& options, const ExplorationSink& sink,
                                     const Progress& progress = {});

/// Explores a thing in a trial, for example with an observer of its own.
using Explore = std::function<Result<Exploration>(std::size_t thing, std::size_t trial)>;

/// The same, where `explore` explores: also one after the other, in the calling thread.
Result<ExploringOutcome> explore_in_turn(const Explorer& explorer, const ExploringPlan& plan,
                                         const Explore& explore, const ExplorationSink& sink,
                                         const Progress& progress = {});

/// Explores in `threads` threads at once, with the same outcome for any number of them: the
/// explorations are passed to `sink` in order, and at most twice the number of threads are ahead of
/// it. `options` are used by all of them.
Result<ExploringOutcome> explore_all(const SimulatedExplorer& explorer, const ExploringPlan& plan,
                                     std::size_t threads, const ExploreOptions& options,
                                     const ExplorationSink& sink, const Progress& progress = {});

}  // namespace somato
