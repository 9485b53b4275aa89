#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/studies/protocol.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/fold_run.h"
#include "studies/question.h"

namespace somato {

/// The trainings of one seed under a protocol.
struct SeedOutcome {
  std::uint64_t seed = 0;
  std::vector<const FoldOutcome*> folds;
};

/// What was asked and how it was divided.
struct Asked {
  const StudyParameters& study;
  const Question& question;
  Protocol protocol;
  const std::vector<Fold>& folds;
};

/// The classes of the label that the fold's map names for its tested samples.
std::vector<std::size_t> predictions(const Classes& classes, const Fold& fold,
                                     const FoldOutcome& outcome);

/// All metrics over the seeds, in the order of docs/reference/results.md; those that say nothing
/// under this protocol are left out.
std::vector<Metric> metrics_of(const Asked& asked, const std::vector<SeedOutcome>& seeds);

}  // namespace somato
