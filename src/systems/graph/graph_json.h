#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "somato/core/parameter.h"
#include "somato/graph/system.h"
#include "somato/maps/grid.h"

namespace somato::detail {

/// A system as GraphData of web/schema/parts.json: `map` is the module that answers, and
/// `parameters` makes the object of a module's parameters.
nlohmann::ordered_json graph_json(
    const System& system, const std::string& map,
    const std::function<nlohmann::ordered_json(std::size_t)>& parameters);

/// A grid as GridData.
nlohmann::ordered_json grid_json(const Grid& grid);

/// Whether the text of a parameter states that no paper gives it.
bool is_not_given(const ParameterInfo& parameter);

}  // namespace somato::detail
