#pragma once

#include <memory>

#include "bodies/explorers/explorer_setup.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_hand.h"

namespace somato::detail {

/// Hand II grasps each object of the table from the poses of the plan; Hand III closes on it.
/// Errors: those of HandScene::build(); kUsage for a table without objects, and if the open Hand II
/// collides with an object at one of the poses.
Result<std::unique_ptr<SimulatedExplorer>> hand_explorer(Hand hand, const ObjectTable& things,
                                                         ExplorerSetup setup);

}  // namespace somato::detail
