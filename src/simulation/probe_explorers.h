#pragma once

#include <memory>

#include "simulation/thing_explorer.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/exploring_parameters.h"

namespace somato::detail {

/// Which probes try a material: one of them, or both in the same exploration.
enum class Probe { kTexture, kHardness, kBoth };

/// Probes try each material of the table, or where it has none those of its objects. Errors:
/// kUsage for a table without either; those of the probes.
Result<std::unique_ptr<ThingExplorer>> probe_explorer(Probe probe, const ObjectTable& things,
                                                      const ExploringParameters& parameters,
                                                      std::uint64_t seed);

/// Hand III with taxels closes on each object of the table, then both probes try its material.
/// Errors: those of closing_explorer() and of the probes.
Result<std::unique_ptr<ThingExplorer>> all_senses_explorer(const ObjectTable& things,
                                                           ExploringParameters parameters,
                                                           std::uint64_t seed);

}  // namespace somato::detail
