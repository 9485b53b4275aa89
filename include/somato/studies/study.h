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
  std::string parts = {};     ///< A folder with the journals of parts, whose trainings are not
                              ///< repeated; or empty.
  bool compare_folds = true;  ///< Whether one more training for each fold of k_folds and
                              ///< object_after_object compares the fold choices.
};

/// The part of a study's trainings that one of several processes runs: training `number`, counted
/// from 1, and every `of`-th after it.
struct StudyPart {
  std::size_t number = 1;
  std::size_t of = 1;

  bool is_whole() const { return of == 1; }
  /// "3-of-7".
  std::string folder_name() const;
};

/// The number of trainings of studies in the journals of all parts.
struct StudyProgress {
  std::size_t done = 0;
  std::size_t trainings = 0;

  bool complete() const { return done == trainings; }
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

/// Runs those trainings of a part of the study that no part has completed, and appends them to a
/// journal in the folder of that part below `options.parts`, which must exist; its name depends on
/// the study and the data, so that several studies share the folder. Once all parts have run, in
/// any order and on any machines, run_study() with the same `parts` only trains the system that it
/// returns. Errors: those of run_study().
Result<StudyProgress> run_part_of_study(const StudyDescription& description,
                                        const Recording& recording, const StudyOptions& options,
                                        const StudyPart& part);

}  // namespace somato
