#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "somato/graph/evaluation.h"
#include "somato/maps/som_parameters.h"
#include "studies/folds/prepared_study.h"

namespace somato {

/// A nearest-neighbour classifier of the baseline.
struct NeighbourKind {
  Similarity distance = Similarity::kEuclidean;
  bool standardized = false;  ///< On vectors standardized on the training part.

  /// Such as "manhattan, standardized".
  std::string name() const;
};

/// The kinds of which the best is chosen; the first one in a tie.
inline constexpr std::array<NeighbourKind, 4> kNeighbourKinds{{{Similarity::kEuclidean, false},
                                                               {Similarity::kEuclidean, true},
                                                               {Similarity::kManhattan, false},
                                                               {Similarity::kManhattan, true}}};

/// The neighbours of the test samples by the kind that was chosen for a label.
struct BestNeighbours {
  std::size_t kind = 0;              ///< Its number in kNeighbourKinds.
  std::vector<std::size_t> nearest;  ///< As in Neighbours.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("kind", self.kind);
    visit("nearest", self.nearest);
  }
  bool operator==(const BestNeighbours&) const = default;
};

/// The nearest training sample of each test sample, as numbers of explorations, for the baseline.
struct Neighbours {
  std::vector<std::size_t> raw;
  std::vector<std::size_t> standardized;  ///< On vectors standardized on the training part.
  std::vector<BestNeighbours> best = {};  ///< For each label of the study; empty: not chosen.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("raw", self.raw);
    visit("standardized", self.standardized);
    visit("best", self.best);
  }
  bool operator==(const Neighbours&) const = default;
};

/// The division of a training part into inner folds, by which the best kind of neighbour is chosen.
struct InnerFolds {
  FoldChoice choice = FoldChoice::kBlocks;
  std::vector<std::size_t> groups = {};  ///< One per exploration: whole groups are tested, if the
                                         ///< training part has two; empty: by `choice`.
  std::size_t most_tests = 1000;  ///< The number of training samples that are tested, at most;
                                  ///< of more, they are taken evenly from each class.
};

/// The inner folds of a protocol: whole groups for leave_group_out, interleaved ones for
/// leave_one_out, whose samples are tested with both neighbours learned, and otherwise those of the
/// study's fold choice. Of many trainings each tests fewer samples.
InnerFolds inner_folds_for(Protocol protocol, const FoldSamples& samples, std::size_t trainings);

/// The neighbours among the training samples of each of the lists of test samples, by the vectors
/// of all of them.
std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors,
                                           const std::vector<std::size_t>& training,
                                           const std::vector<std::vector<std::size_t>>& tests);

/// The same for a fold: of its test samples, then of those altered by each alteration; and by the
/// kind of neighbour that names most of the training samples rightly in inner folds.
std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors,
                                           const PreparedStudy& prepared, const Fold& fold,
                                           const InnerFolds& inner = {});

}  // namespace somato
