#pragma once

#include <cstddef>
#include <vector>

#include "somato/studies/results.h"

namespace somato {

/// Counts of tested explorations that are named rightly.
struct RightNames {
  std::size_t answered = 0;  ///< The system answers their class; "unknown" is not right.
  std::size_t nearest = 0;   ///< The most similar class is theirs.
  std::size_t baseline = 0;  ///< The nearest exploration, of those trained on or named, has theirs.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("answered", self.answered);
    visit("nearest", self.nearest);
    visit("baseline", self.baseline);
  }
  bool operator==(const RightNames&) const = default;
};

/// The tests of a system that knows the names of some explorations of a class that was left out.
struct TeachingStage {
  RightNames taught;              ///< Other explorations of that class.
  RightNames known;               ///< Held-out explorations of the classes of the training.
  std::size_t known_changed = 0;  ///< Those of the latter with another answer than at first.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("taught", self.taught);
    visit("known", self.known);
    visit("known_changed", self.known_changed);
  }
  bool operator==(const TeachingStage&) const = default;
};

/// The results of one class, or sums over several.
struct TeachingOutcome {
  std::vector<TeachingStage> stages;  ///< Before the first name and after each; empty: no test.
  std::size_t taught_tested = 0;
  std::size_t known_tested = 0;
  std::size_t names = 0;    ///< Names that were given.
  std::size_t refused = 0;  ///< Those that the system could not learn: all neurons have names.

  /// Sums of the same number of stages.
  void add(const TeachingOutcome& other);

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("stages", self.stages);
    visit("taught_tested", self.taught_tested);
    visit("known_tested", self.known_tested);
    visit("names", self.names);
    visit("refused", self.refused);
  }
  bool operator==(const TeachingOutcome&) const = default;
};

/// The metrics of docs/reference/results.md, from the sums over the folds of each seed. Throws
/// InvalidArgument without tested explorations.
std::vector<Metric> teaching_metrics(const std::vector<TeachingOutcome>& seeds);

}  // namespace somato
