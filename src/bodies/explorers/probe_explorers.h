#pragma once

#include <memory>

#include "bodies/explorers/explorer_setup.h"
#include "bodies/probes/probe.h"
#include "somato/bodies/object_table.h"

namespace somato::detail {

/// Probes try each material of the table, or where it has none each of those of its objects.
/// Errors: kUsage for a table without any; those of the probes.
Result<std::unique_ptr<SimulatedExplorer>> probe_explorer(Probe probe, const ObjectTable& things,
                                                          ExplorerSetup setup);

/// Hand III with taxels closes on each object of the table, then both probes try its material.
/// Errors: those of hand_explorer() and of the probes.
Result<std::unique_ptr<SimulatedExplorer>> all_senses_explorer(const ObjectTable& things,
                                                               ExplorerSetup setup);

}  // namespace somato::detail
