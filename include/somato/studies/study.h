#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"
#include "somato/recording/recording.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// How a study runs, as far as its results do not depend on it.
struct StudyOptions {
  std::size_t threads = 1;
  Progress progress;  ///< Told trainings, from one thread at a time.
};

/// What a study found, and a map to look at.
struct StudyOutcome {
  StudyResults results;
  Som map;                           ///< Trained on all samples with the first seed.
  std::vector<std::size_t> winners;  ///< Of all samples on that map.
  Classes classes;                   ///< Of all samples.
};

/// Runs a study: for each protocol and seed, trains a map on the training part of every fold and
/// tests it on the others, beside the nearest-neighbour baseline on the same vectors. Everything
/// that learns, standardization included, learns from the training part alone. The same for any
/// number of threads.
///
/// Errors: a recording that is not valid (kData) or lacks the channels or labels asked for
/// (kUsage); fewer than two explorations, only one class, or an individual in two classes (kData);
/// a constant element (kData, unless told to make it zero); kInterrupted.
Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options = {});

}  // namespace somato
