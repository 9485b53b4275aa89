#pragma once

#include "somato/graph/module.h"
#include "somato/maps/grid.h"
#include "somato/maps/som.h"

namespace somato::modules {

/// A module whose learned values are a map, which studies and the live view access directly.
class MapModule : public Module, public Learner {
 public:
  /// The trained map; before training, a map without neurons.
  virtual const Som& som() const = 0;

  /// The grid of the map; before training of a map that grows, a row of its maximum size.
  virtual Grid grid() const = 0;

  Learner* learner() override { return this; }
};

}  // namespace somato::modules
