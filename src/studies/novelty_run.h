#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/maps/labels.h"
#include "somato/maps/novelty.h"
#include "studies/fold_run.h"
#include "studies/prepared_study.h"

namespace somato {

/// The nearest labelled neuron of a sample.
struct LabelledNeuron {
  std::size_t label = 0;  ///< Its class.
  double distance = 0.0;
};

/// The map of a trained fold, whose neurons have the classes of the training explorations.
class LabelledMap {
 public:
  /// All must outlive it.
  LabelledMap(const TrainedFold& trained, const PreparedStudy& prepared,
              const std::vector<std::size_t>& training);

  /// The nearest labelled neuron for each exploration, for which the inputs must be known.
  std::vector<LabelledNeuron> nearest(const std::vector<std::size_t>& explorations) const;

  /// The scales of the classes: the mean distance of their training explorations, each from the
  /// neurons that other explorations have won. Errors: those of class_scales().
  Result<std::vector<double>> scales() const;

 private:
  double distance_from_others(std::size_t place) const;

  const Som& som_;
  const ExplorationValues& inputs_;
  std::vector<std::size_t> classes_;  ///< Those of the training explorations.
  std::size_t count_;                 ///< The number of classes.
  std::vector<std::size_t> places_;   ///< The places of these among the inputs.
  std::vector<std::size_t> winners_;  ///< The winners of these.
  NeuronLabels labels_;
};

/// The threshold for unknown explorations of a system that was trained on `training`. The training
/// explorations are divided into `calibration_folds` parts; each part is read by a system trained
/// on the others, with the scales of that system, and the threshold follows from the scores of all
/// parts. No other exploration has an influence. Errors: those of training; too few explorations
/// for the false-alarm rate (kData).
Result<Novelty> find_novelty(const StudyDescription& description, const PreparedStudy& prepared,
                             const TrainedFold& trained, const std::vector<std::size_t>& training,
                             std::uint64_t seed, const Progress& progress);

/// The scores of the known and the test explorations of a fold of leave_class_out.
NoveltyOutcome test_novelty(const Novelty& novelty, const TrainedFold& trained,
                            const PreparedStudy& prepared, const Fold& fold);

}  // namespace somato
