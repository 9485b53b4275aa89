#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "studies/question.h"

namespace somato {

/// What one training gave: everything the metrics of a seed are made of.
struct FoldOutcome {
  std::vector<std::size_t> winners;                ///< Of the tested samples.
  std::vector<std::size_t> predictions;            ///< Classes of the tested samples.
  std::vector<std::size_t> raw_baseline;           ///< The same by the nearest neighbour.
  std::vector<std::size_t> standardized_baseline;  ///< The same on standardized vectors.
  double summed_distance = 0.0;                    ///< Of the tested samples from their winners.
  double torn = 0.0;             ///< Tested samples whose two winners do not touch.
  bool apart = false;            ///< No winner shared between classes, learned or tested.
  bool connected = false;        ///< Each class one region, learned or tested.
  double connected_wrong = 0.0;  ///< Share of wrong groupings connected.

  bool operator==(const FoldOutcome&) const = default;
};

/// A trained system with what its map sees.
struct TrainedFold {
  System system;
  std::vector<std::size_t> samples;  ///< Learned or tested, ascending.
  Samples inputs;                    ///< Of the map, one a sample.
  Samples vectors;                   ///< For the baseline, one a sample.
};

/// Trains the system on the fold's training part alone, with `seed`, and computes what its map sees
/// of that part and of the tested one.
Result<TrainedFold> train_fold(const StudyDescription& description, const Question& question,
                               const Fold& fold, std::uint64_t seed, const Progress& progress);

/// Tests what was trained on a fold.
FoldOutcome test_fold(const TrainedFold& trained, const Question& question, const Fold& fold,
                      const std::vector<std::vector<std::size_t>>& wrong_groupings);

}  // namespace somato
