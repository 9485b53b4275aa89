#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/studies/results.h"

namespace somato {

/// Counts of the tested explorations that a learner names rightly while it learns objects one after
/// another.
struct LearnerTests {
  /// `right[k][j]`: the number of tested explorations of the j-th learned object that it names
  /// rightly after k + 1 objects; a row has k + 1 numbers.
  std::vector<std::vector<std::size_t>> right;
  std::size_t vectors = 0;  ///< The number of vectors that it keeps in the end.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("right", self.right);
    visit("vectors", self.vectors);
  }
  bool operator==(const LearnerTests&) const = default;
};

/// The learners that are compared, in the order in which their results are kept.
enum class ContinualLearner { kMap, kPlainSom, kNearest, kNearestSameMemory };
inline constexpr std::size_t kContinualLearners = 4;

/// The test of one fold of the protocol object_after_object.
struct ObjectsOutcome {
  std::vector<std::size_t> tested;  ///< The number of tested explorations of each learned object.
  std::vector<LearnerTests> learners;   ///< One for each ContinualLearner; empty: another protocol.
  std::size_t elements = 0;             ///< The elements of a vector.
  std::size_t neurons = 0;              ///< The neurons of the map in the end.
  std::vector<std::size_t> named = {};  ///< The classes that votes name for the tested samples.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("tested", self.tested);
    visit("learners", self.learners);
    visit("elements", self.elements);
    visit("neurons", self.neurons);
    visit("named", self.named);
  }
  bool operator==(const ObjectsOutcome&) const = default;
};

/// The share of the tested explorations of the first `objects` objects that are named rightly after
/// these were learned.
double accuracy_after(std::size_t objects, const std::vector<std::size_t>& tested,
                      const LearnerTests& learner);

/// The mean over all objects except the last of the highest accuracy before the last object was
/// learned minus the final accuracy (Chaudhry and others, Riemannian walk for incremental learning,
/// ECCV 2018, equation 3); 0 for one object.
double forgetting(const std::vector<std::size_t>& tested, const LearnerTests& learner);

/// The sums of the folds of one seed, which learn the objects in the same order; vectors are added
/// too.
ObjectsOutcome sum_of(const std::vector<const ObjectsOutcome*>& folds);

/// The metrics of the protocol; `seeds` has the outcomes of the folds of each seed.
std::vector<Metric> continual_metrics(const std::vector<std::vector<const ObjectsOutcome*>>& seeds);

}  // namespace somato
