#pragma once

#include <cstddef>

#include "somato/core/samples.h"
#include "somato/core/signal.h"
#include "somato/graph/module.h"
#include "somato/maps/grid.h"
#include "somato/maps/labels.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som.h"

namespace somato::modules {

/// A module whose learned values are a map, which studies and the live view access directly.
class MapModule : public Module, public Learner {
 public:
  /// The trained map; before training, a map without neurons.
  virtual const Som& som() const = 0;

  /// The grid of the map; before training of a map that grows, a row of its maximum size.
  virtual Grid grid() const = 0;

  /// The order before and after the refinement of the last training; nullptr without one.
  virtual const RefinedOrder* refined_order() const { return nullptr; }

  /// Learns `inputs` in addition to what it has learned, with the seed, draws, progress and
  /// observer of the plan, and returns the origins of the neurons. The map must be trained; if
  /// learning fails, it is unchanged. Errors: those of Learner::learn().
  virtual Result<NeuronOrigins> learn_further(const LearningPlan& plan, const Samples& inputs) = 0;

  /// Adds a neuron with the weights `input` and the highest number; all others remain as they are.
  /// Returns false if the map cannot add one. It must be trained. A map that learns names gives the
  /// neuron that of the class.
  virtual bool add_neuron(const SignalView& /*input*/, std::size_t /*the_class*/) { return false; }

  /// Gives a neuron of a trained map the weights `input`, after normalization; all others remain as
  /// they are. A map that learns names gives it that of the class.
  virtual void place_neuron(std::size_t neuron, const SignalView& input, std::size_t the_class) = 0;

  Learner* learner() override { return this; }
};

}  // namespace somato::modules
