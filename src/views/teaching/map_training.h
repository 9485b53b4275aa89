#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "views/session/view_source.h"

namespace somato::live {

/// A look at a system that learns.
struct TrainingSnapshot {
  std::string module;  ///< The map.
  std::uint64_t step = 0;
  std::uint64_t steps = 0;
  double radius = 0.0;
  double learning_rate = 0.0;
  std::vector<std::size_t>
      winners;  ///< The winners of the first samples; none while other modules learn.
  std::vector<std::string> classes;  ///< The classes of the same samples.
  std::vector<double> u_matrix;      ///< Or none.
  bool done = false;
};

/// Called now and then; when it returns false the training ends with an Error of kind kInterrupted.
using SnapshotObserver = std::function<bool(const TrainingSnapshot&)>;

/// Trains a system on all explorations of a recording and labels its map by majority, with about a
/// hundred snapshots of the map (25 for a map of more than four million weights, as each takes
/// time). Snapshots have no effect: the map has the same bits as that of `somato run`. A map that
/// learns together with other modules is only shown at the end. With enough explorations, three
/// more trainings, each without a third of them, find the threshold for unknown explorations with a
/// false-alarm rate of 5 %. `should_continue` is called before
/// each exploration is evaluated, before the first snapshot; returning false ends the training as
/// well. Errors: kUsage and kData with their location; kInterrupted.
Result<std::shared_ptr<const SystemModel>> train_visibly(
    const ViewSystem& system, const Recording& recording, std::uint64_t seed,
    const SnapshotObserver& observer, const std::function<bool()>& should_continue);

}  // namespace somato::live
