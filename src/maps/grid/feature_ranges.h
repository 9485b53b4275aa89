#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/process_group.h"
#include "somato/core/samples.h"

namespace somato {

/// Widens `low` and `high`, the least and the greatest value of each feature, by the samples. Empty
/// ones become the samples' own.
void widen_ranges(const Samples& samples, std::vector<float>& low, std::vector<float>& high);

/// Widens the ranges of `size` features by those of all processes. Empty ones do not widen them.
void combine_ranges(ProcessGroup& processes, std::size_t size, std::vector<float>& low,
                    std::vector<float>& high);

}  // namespace somato
