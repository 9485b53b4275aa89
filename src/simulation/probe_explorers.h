#pragma once

#include <memory>
#include <vector>

#include "simulation/probe.h"
#include "simulation/thing_explorer.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/exploring_parameters.h"

namespace somato::detail {

/// The materials that probes try: the table's own, or where it has none those of its objects, each
/// once.
std::vector<Material> materials_to_explore(const ObjectTable& things);

/// Probes try each of materials_to_explore(). Errors: kUsage for a table without any; those of the
/// probes.
Result<std::unique_ptr<ThingExplorer>> probe_explorer(Probe probe, const ObjectTable& things,
                                                      const ExploringParameters& parameters,
                                                      std::uint64_t seed);

/// Hand III with taxels closes on each object of the table, then both probes try its material.
/// Errors: those of closing_explorer() and of the probes.
Result<std::unique_ptr<ThingExplorer>> all_senses_explorer(const ObjectTable& things,
                                                           ExploringParameters parameters,
                                                           std::uint64_t seed);

}  // namespace somato::detail
