#pragma once

#include <cstdint>

#include "somato/core/result.h"
#include "somato/maps/novelty.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/prepared_study.h"
#include "studies/measures/teaching_measures.h"

namespace somato {

/// Gives the system of a fold of leave_class_out, with its threshold for unknown explorations, the
/// names of `taught_per_class` explorations of the class left out, one after another, in the order
/// that the seed draws (see teach()). Before the first and after each, the other explorations of
/// that class and the held-out ones of known classes are tested. `winners` has the winner of each
/// training exploration. Errors: those of teach(), except that a name is refused and counted if all
/// neurons have names.
Result<TeachingOutcome> test_teaching(const StudyParameters& study, const PreparedStudy& prepared,
                                      const Fold& fold, TrainedFold trained,
                                      const std::vector<std::size_t>& winners,
                                      const Novelty& novelty, std::uint64_t seed);

}  // namespace somato
