#pragma once

#include <memory>

#include "simulation/thing_explorer.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/exploring_parameters.h"

namespace somato::detail {

/// Hand II grasps each object of the table from the poses of the plan. Errors: those of
/// HandScene::build(); kUsage for a table without objects and when the open hand meets an object at
/// one of the poses.
Result<std::unique_ptr<ThingExplorer>> grasping_explorer(const ObjectTable& things,
                                                         const ExploringParameters& parameters,
                                                         std::uint64_t seed);

/// Hand III closes on each object of the table. Errors as above.
Result<std::unique_ptr<ThingExplorer>> closing_explorer(const ObjectTable& things,
                                                        const ExploringParameters& parameters,
                                                        std::uint64_t seed);

}  // namespace somato::detail
