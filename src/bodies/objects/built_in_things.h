#pragma once

#include <vector>

#include "somato/bodies/object_table.h"

namespace somato {

/// The objects of all built-in tables.
const std::vector<Object>& built_in_objects();

/// Whether all objects and materials of `table` are built-in ones.
bool are_built_in(const ObjectTable& table);

}  // namespace somato
