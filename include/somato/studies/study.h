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

/// Options of a study that do not affect its results, and its test recording.
struct StudyOptions {
  std::size_t threads = 1;
  Progress progress;                     ///< In trainings; called from one thread at a time.
  const Recording* test_data = nullptr;  ///< A recording for the protocol test_data, or none.
  std::string journal =
      {};  ///< A file for completed trainings, so that the study can be resumed after an
           ///< interruption; or empty. The caller removes it after saving the results.
};

/// The results of a study, and a trained system.
struct StudyOutcome {
  PartResults results;               ///< Its recordings have no name and no source.
  SystemModel model;                 ///< Trained on all samples with the first seed.
  std::vector<std::size_t> winners;  ///< The winners of all samples on the output map.
  Classes classes;                   ///< The classes of all samples.

  /// The name of the output map.
  const Som& map() const;
};

/// Runs a study: for each protocol and seed, trains the system on the training part of every fold
/// and tests it on the others, with the nearest-neighbour baseline on the vectors from which the
/// map learns. All learning uses the training part only. The results are the same for any number of
/// threads, and for a study that was interrupted and resumed.
///
/// Errors: a recording that is not valid (kData) or lacks the required channels or labels (kUsage);
/// a system that cannot be built (kUsage); fewer than two explorations, only one class, or an
/// individual in two classes (kData); errors of the system's modules; a journal of another study
/// (kUsage); kInterrupted.
Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options = {});

}  // namespace somato
