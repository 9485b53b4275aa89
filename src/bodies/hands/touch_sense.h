#pragma once

#include <string>
#include <vector>

#include "bodies/physics/physics.h"

namespace somato::detail {

/// The taxels of a model: its geoms named taxel_NAME, in their order.
struct Taxels {
  std::vector<std::string> names;
  std::vector<int> taxel_of_geom;  ///< For each geom of the model; -1 where it is none.
};

Taxels find_taxels(const mjModel& model);

/// Adds up the normal forces (N) of the contacts of each taxel's own geom. The engine's sensor of
/// type `touch` will not do: it also counts contacts of other geoms of the same body.
void read_forces(const mjModel& model, const mjData& data, const Taxels& taxels,
                 std::vector<double>& forces);

}  // namespace somato::detail
