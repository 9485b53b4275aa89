#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"

namespace somato {

/// The module whose output the baseline of a map compares: the input of the map, or of a
/// standardization directly before the map.
std::size_t vectors_of_map(const System& system, std::size_t map);

/// The modules whose outputs the baseline of a module with one value per exploration compares, each
/// once: those of the maps that the module's output is computed from, and what becomes one value
/// per exploration without a map. The target of an association affects learning only and does not
/// count.
std::vector<std::size_t> vectors_behind(const System& system, std::size_t module);

/// The outputs of these modules for the explorations for which all are known, concatenated.
ExplorationValues values_of(Activations& activations, const std::vector<std::size_t>& modules);

/// The module that calls up the activity of `map`. Errors (kUsage, at `where`): an unknown name; a
/// module with another output than one plane in the shape of the map per exploration.
Result<std::size_t> find_recall(const System& system, std::size_t map, const std::string& name,
                                const std::string& where);

/// Whether a module is an association, which has an input and a target, in this order.
bool is_association(const SystemModule& module);

}  // namespace somato
