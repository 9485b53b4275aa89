#pragma once

#include "somato/core/samples.h"
#include "somato/graph/module.h"
#include "somato/maps/grid.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"

namespace somato::modules {

/// A module whose learned values are a map, which studies and the live view access directly.
class MapModule : public Module, public Learner {
 public:
  /// The trained map; before training, a map without neurons.
  virtual const Som& som() const = 0;

  /// The grid of the map; before training of a map that grows, a row of its maximum size.
  virtual Grid grid() const = 0;

  /// Learns `inputs` in addition to what it has learned, with the seed, draws, progress and
  /// observer of the plan, and returns the origins of the neurons. The map must be trained; if
  /// learning fails, it is unchanged. Errors: those of Learner::learn().
  virtual Result<NeuronOrigins> learn_further(const LearningPlan& plan, const Samples& inputs) = 0;

  Learner* learner() override { return this; }
};

}  // namespace somato::modules
