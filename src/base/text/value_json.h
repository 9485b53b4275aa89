#pragma once

#include <nlohmann/json.hpp>

#include "somato/core/value.h"

namespace somato {

/// A value of a description as JSON. Numbers that are not finite are written as null.
nlohmann::ordered_json to_json_value(const Value& value);

}  // namespace somato
