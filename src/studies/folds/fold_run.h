#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/studies/results.h"
#include "studies/description/exploration_samples.h"
#include "studies/folds/baseline.h"
#include "studies/folds/prepared_study.h"
#include "studies/measures/forgetting.h"
#include "studies/measures/novelty_measures.h"
#include "studies/measures/teaching_measures.h"

namespace somato {

/// The results of altered test samples.
struct AlteredOutcome {
  std::vector<std::size_t> named_by;  ///< As in FoldOutcome.
  Neighbours nearest;                 ///< Among the unaltered training samples.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("named_by", self.named_by);
    visit("nearest", self.nearest);
  }
  bool operator==(const AlteredOutcome&) const = default;
};

/// The order of a map for its training samples before and after labels have refined it; empty
/// without a refinement.
struct RefinementOutcome {
  std::vector<double> topographic_errors;  ///< Before and after, like the others.
  std::vector<double> trustworthiness;     ///< Empty if there are too few samples.
  std::vector<double> continuity;          ///< Empty if there are too few samples.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("topographic_errors", self.topographic_errors);
    visit("trustworthiness", self.trustworthiness);
    visit("continuity", self.continuity);
  }
  bool operator==(const RefinementOutcome&) const = default;
};

/// The results of one training, from which all metrics are computed, for any label.
struct FoldOutcome {
  std::vector<std::size_t> training_winners;  ///< The winners of the training samples.
  std::vector<std::size_t> winners;           ///< The winners of the test samples.
  std::vector<std::size_t> named_by;         ///< The neurons that name the tested samples: the most
                                             ///< similar of those that training samples won, with a
                                             ///< recall the strongest of these.
  Neighbours nearest;                        ///< The neighbours of the test samples.
  double summed_distance = 0.0;              ///< Distances of the test samples from their winners.
  double topographic_errors = 0.0;           ///< Tested samples whose two winners do not touch.
  std::vector<AlteredOutcome> altered = {};  ///< One for each alteration.
  std::vector<std::size_t> recalled = {};    ///< The strongest neurons of the activities called up
                                             ///< for the test samples; empty without a recall.
  std::vector<PredictionOutcome> predictions = {};  ///< For each prediction of the study.
  TrainedMap map = {};  ///< The trained map; distances only where all samples are tested by it.
  ObjectsOutcome objects = {};        ///< Only with object_after_object.
  NoveltyOutcome novelty = {};        ///< Only with leave_class_out.
  TeachingOutcome teaching = {};      ///< Only with leave_class_out and taught_per_class.
  RefinementOutcome refinement = {};  ///< Only of maps that labels refine.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("training_winners", self.training_winners);
    visit("winners", self.winners);
    visit("named_by", self.named_by);
    visit("nearest", self.nearest);
    visit("summed_distance", self.summed_distance);
    visit("topographic_errors", self.topographic_errors);
    visit("altered", self.altered);
    visit("recalled", self.recalled);
    visit("predictions", self.predictions);
    visit("grid", self.map.grid);
    visit("u_matrix", self.map.u_matrix);
    visit("edge_distances", self.map.edge_distances);
    visit("objects", self.objects);
    visit("novelty", self.novelty);
    visit("teaching", self.teaching);
    visit("refinement", self.refinement);
  }
  bool operator==(const FoldOutcome&) const = default;
};

/// A trained system with what its map sees: of the explorations learned or tested at least.
struct TrainedFold {
  System system;
  ExplorationValues inputs;                    ///< The inputs of the map.
  ExplorationValues vectors;                   ///< For the baseline.
  std::optional<ExplorationValues> recalled;   ///< The activities called up, of those tested.
  std::vector<PredictionOutcome> predictions;  ///< For each prediction of the study.
};

/// Trains the system on the fold's training part only, with `seed`, and computes the input of its
/// map for that part and for the tested one.
Result<TrainedFold> train_fold(const StudyDescription& description, const PreparedStudy& prepared,
                               const Fold& fold, std::uint64_t seed, const Progress& progress);

/// Tests a trained system on a fold. `nearest` are those of nearest_neighbours(), or empty.
FoldOutcome test_fold(const TrainedFold& trained, const PreparedStudy& prepared, const Fold& fold,
                      std::vector<Neighbours> nearest);

}  // namespace somato
