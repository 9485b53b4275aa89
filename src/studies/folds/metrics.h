#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/description/folds.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/prepared_study.h"

namespace somato {

/// The trainings of one seed under a protocol.
struct SeedOutcome {
  std::uint64_t seed = 0;
  std::vector<const FoldOutcome*> folds;
};

/// A study and its division into folds.
struct MeasuredStudy {
  const StudyParameters& study;
  const PreparedStudy& prepared;
  Protocol protocol;
  const std::vector<Fold>& folds;
};

/// The classes of the label that the fold's map names for its tested samples.
std::vector<std::size_t> predictions(const Classes& classes, const Fold& fold,
                                     const FoldOutcome& outcome);

/// The same for samples that these neurons name.
std::vector<std::size_t> predictions(const Classes& classes, const Fold& fold,
                                     const FoldOutcome& outcome,
                                     const std::vector<std::size_t>& named_by);

/// All metrics over the seeds, in the order of docs/reference/results.md; those that are not
/// defined under this protocol are omitted.
std::vector<Metric> metrics_of(const MeasuredStudy& study, const std::vector<SeedOutcome>& seeds);

/// Adds `best_neighbour_accuracy` for the label of the study, if it was measured, after
/// `baseline_accuracy`.
void add_best_neighbour(const MeasuredStudy& study, const std::vector<SeedOutcome>& seeds,
                        std::vector<Metric>& metrics);

}  // namespace somato
