#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/studies/study_parameters.h"
#include "studies/description/folds.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/prepared_study.h"

namespace somato {

/// The order in which a seed learns the objects, which are the classes of the study.
std::vector<std::size_t> order_of_objects(std::size_t objects, std::uint64_t seed);

/// One fold of the protocol object_after_object: the system is trained on the training part of the
/// first object; then its output map learns further from that of one object after another, and all
/// objects so far are tested after each. The other modules remain as the first object left them.
/// docs/continual.md describes replay and the other learners that are compared. `nearest` gives the
/// baseline's neighbours from the vectors of all its samples; without it, there are none.
Result<FoldOutcome> learn_object_after_object(
    const StudyDescription& description, const PreparedStudy& prepared, const Fold& fold,
    std::uint64_t seed, const Progress& progress,
    const std::function<Neighbours(const TrainedFold&)>& nearest = {});

}  // namespace somato
