#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/maps/novelty.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/prepared_study.h"
#include "systems/walk/labelled_map.h"

namespace somato {

/// The map of a trained fold, whose neurons have the classes of the training explorations. All must
/// outlive it. `shrinkage` is that of LabelledMap.
LabelledMap labelled_map(const TrainedFold& trained, const PreparedStudy& prepared,
                         const std::vector<std::size_t>& training, std::optional<double> shrinkage);

/// The threshold for unknown explorations of a system that was trained on `training`. The training
/// explorations are divided into `calibration_folds` parts; each part is read by a system trained
/// on the others, with the scales and the whitening of that system, and the threshold follows from
/// the scores of all parts. No other exploration has an influence. Errors: those of training; too
/// few explorations for the false-alarm rate (kData); a whitening_shrinkage for a map that cannot
/// be whitened (kUsage).
Result<Novelty> find_novelty(const StudyDescription& description, const PreparedStudy& prepared,
                             const TrainedFold& trained, const std::vector<std::size_t>& training,
                             std::uint64_t seed, const Progress& progress);

/// The scores of the known and the test explorations of a fold of leave_class_out.
NoveltyOutcome test_novelty(const Novelty& novelty, const TrainedFold& trained,
                            const PreparedStudy& prepared, const Fold& fold);

}  // namespace somato
