#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato {

/// Refuses (kUsage, with the nearest name) what no study can give as a metric: "accuracy", the same
/// of another label as "shape.accuracy" or of wrong groupings as "accuracy_by_luck", "mapped_with A
/// B".
Result<void> check_metric_name(const std::string& name, const std::string& where);

}  // namespace somato
