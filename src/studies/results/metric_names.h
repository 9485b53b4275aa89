#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato {

/// Refuses (kUsage, with the nearest name) names of metrics that no study provides. Valid names:
/// "accuracy", the same for another label as "shape.accuracy" or of wrong groupings as
/// "accuracy_chance", "mapped_with A B".
Result<void> check_metric_name(const std::string& name, const std::string& where);

}  // namespace somato
