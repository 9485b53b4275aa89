#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/graph/som_model.h"
#include "somato/graph/system_model.h"

namespace somato {

/// The map of a module of a trained system as a model. Its inputs are those of the module, and its
/// neurons have labels if the system answers with it. An empty `module` is the only map of the
/// system. Errors (kUsage, at `where`, with the names of the maps): there is no such map, or
/// `module` is empty and there are several.
Result<SomModel> map_of_system(const SystemModel& model, const std::string& module,
                               const std::string& where);

}  // namespace somato
