#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/grid.h"
#include "somato/recording/recording.h"
#include "somato/studies/results.h"
#include "studies/description/folds.h"

namespace somato {

/// An association whose predictions are compared with its target.
struct Prediction {
  std::string name;
  std::size_t module = 0;
  std::size_t target = 0;
  Rate rate = Rate::kExploration;    ///< The rate of the values that are compared.
  bool has_strongest = false;        ///< Whether the greatest element of a target has a meaning:
                                     ///< the activity of a map, or a one-hot code.
  std::optional<Grid> grid;          ///< The grid of a target that is a map.
  std::vector<std::size_t> vectors;  ///< Modules compared by the nearest neighbour; none for
                                     ///< frames.
};

/// Sums over values that were predicted, or taken from elsewhere.
struct Agreement {
  double squared = 0.0;   ///< Mean squares of the differences of their elements.
  double right = 0.0;     ///< Values with the same strongest element as the target.
  double distance = 0.0;  ///< Distances of the strongest neurons on the map.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("squared", self.squared);
    visit("right", self.right);
    visit("distance", self.distance);
  }
  bool operator==(const Agreement&) const = default;
};

/// The comparison of the test values of one fold. Of frames the first of each exploration is left
/// out, since nothing precedes it.
struct PredictionOutcome {
  double values = 0.0;
  double explorations = 0.0;
  double steps_right = 0.0;  ///< Frames before the first with another strongest element.
  Agreement predicted;
  Agreement mean;                  ///< The mean of the training targets.
  Agreement nearest;               ///< The target of the nearest training exploration.
  Agreement nearest_standardized;  ///< The same, on standardized vectors.
  Agreement preceding;             ///< The target in the preceding frame.
  Agreement chance;                ///< Expected for predictions in random order.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("values", self.values);
    visit("explorations", self.explorations);
    visit("steps_right", self.steps_right);
    visit("predicted", self.predicted);
    visit("mean", self.mean);
    visit("nearest", self.nearest);
    visit("nearest_standardized", self.nearest_standardized);
    visit("preceding", self.preceding);
    visit("chance", self.chance);
  }
  bool operator==(const PredictionOutcome&) const = default;
};

/// The predictions of the study. Errors (kUsage, at `where`): an unknown name, or a module that is
/// not an association.
Result<std::vector<Prediction>> find_predictions(const System& system,
                                                 const std::vector<std::string>& names,
                                                 const std::string& where);

/// Compares the predictions of a trained system for the test explorations of a fold with their
/// targets. Errors: those of evaluate().
Result<PredictionOutcome> compare_prediction(const System& system, const Recording& recording,
                                             const Prediction& prediction, const Fold& fold,
                                             Activations& activations);

/// The metrics of a prediction, with its name as a prefix: docs/reference/results.md. `outcomes`
/// holds those of each fold for each seed.
std::vector<Metric> prediction_metrics(
    const Prediction& prediction, const std::vector<std::vector<const PredictionOutcome*>>& seeds);

}  // namespace somato
