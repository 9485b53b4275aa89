#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "somato/graph/system.h"
#include "somato/maps/grid.h"
#include "somato/studies/results.h"

namespace somato::detail {

/// A system as GraphData of web/src/parts/data.ts, with its parameters as `settings` say; `map` is
/// the module that answers.
nlohmann::ordered_json graph_json(const System& system, std::size_t map,
                                  const std::vector<Settings>& settings);

/// A grid as GridData.
nlohmann::ordered_json grid_json(const Grid& grid);

/// The parameters of all modules in `settings` that no paper gives, as a list of NotGiven.
nlohmann::ordered_json not_given_json(const std::vector<Settings>& settings);

/// Whether the text of a parameter says that no paper gives it.
bool is_not_given(const ParameterInfo& parameter);

}  // namespace somato::detail
