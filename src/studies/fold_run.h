#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/maps/product_som.h"
#include "studies/exploration_samples.h"
#include "studies/question.h"

namespace somato {

/// The nearest training sample of each tested one, as numbers of explorations: what the plain
/// baseline goes by.
struct Neighbours {
  std::vector<std::size_t> raw;
  std::vector<std::size_t> standardized;  ///< On vectors standardized on the training part.

  bool operator==(const Neighbours&) const = default;
};

/// What one training gave: everything that metrics are made of, whatever label they ask for.
struct FoldOutcome {
  std::vector<std::size_t> training_winners;  ///< Of the samples it learned from.
  std::vector<std::size_t> winners;           ///< Of the tested samples.
  std::vector<std::size_t> named_by;  ///< The neurons that name the tested samples: the most
                                      ///< similar of those that training samples won.
  Neighbours nearest;                 ///< Of the tested samples.
  double summed_distance = 0.0;       ///< Of the tested samples from their winners.
  double torn = 0.0;                  ///< Tested samples whose two winners do not touch.

  bool operator==(const FoldOutcome&) const = default;
};

/// A trained system with what its map sees: of the explorations learned or tested at least.
struct TrainedFold {
  System system;
  ExplorationValues inputs;   ///< Of the map.
  ExplorationValues vectors;  ///< For the baseline.
  /// The map that answers, where its inner products tell all that is asked of it: then the system
  /// has no such map before form_map().
  std::optional<ProductSom> products;
};

/// Trains the system on the fold's training part alone, with `seed`, and computes what its map sees
/// of that part and of the tested one.
Result<TrainedFold> train_fold(const StudyDescription& description, const Question& question,
                               const Fold& fold, std::uint64_t seed, const Progress& progress);

/// Gives the system its map, with weights.
void form_map(TrainedFold& trained, const Question& question);

/// The neighbours of a fold's tested samples among what it learned from, by the vectors of all of
/// them.
Neighbours nearest_neighbours(const ExplorationValues& vectors, const Fold& fold);

/// Tests what was trained on a fold.
FoldOutcome test_fold(const TrainedFold& trained, const Question& question, const Fold& fold,
                      Neighbours nearest);

}  // namespace somato
