#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"
#include "somato/recording/recording.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// How a study runs, as far as its results do not depend on it; and what it is tested with.
struct StudyOptions {
  std::size_t threads = 1;
  Progress progress;                     ///< Told trainings to run, from one thread at a time.
  const Recording* test_data = nullptr;  ///< A recording for the protocol test_data, or none.
  std::string journal = {};  ///< A file where trainings that are done are kept, so that the study
                             ///< can go on after it was stopped; or empty. Whoever keeps the
                             ///< results removes it.
};

/// What a study found, and a trained system to look at and to use.
struct StudyOutcome {
  StudyResults results;
  SystemModel model;                 ///< Trained on all samples with the first seed.
  std::vector<std::size_t> winners;  ///< Of all samples on the map that answers.
  Classes classes;                   ///< Of all samples.

  /// The map that answers.
  const Som& map() const;
};

/// Runs a study: for each protocol and seed, trains the system on the training part of every fold
/// and tests it on the others, beside the nearest-neighbour baseline on the vectors that the map
/// learns from. Everything that learns does so from the training part alone. The same for any
/// number of threads, and for a study that was interrupted and gone on with.
///
/// Errors: a recording that is not valid (kData) or lacks the channels or labels asked for
/// (kUsage); a system that cannot be built (kUsage); fewer than two explorations, only one class,
/// or an individual in two classes (kData); whatever the system's modules refuse; a journal of
/// another study (kUsage); kInterrupted.
Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options = {});

}  // namespace somato
