#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The value of a label of each exploration; errors as find_label().
Result<std::vector<std::string>> labels_of(const Recording& recording, const std::string& name);

/// The same, with equal numbers for equal values; every exploration has a different one if `name`
/// is empty.
Result<std::vector<std::size_t>> numbers_of(const Recording& recording, const std::string& name);

}  // namespace somato
