#pragma once

#include <vector>

#include "workload_data.h"

namespace somato::bench {

/// The cases on maps. `scale` divides samples and steps: 1 is the whole case, 20 a quick one.
std::vector<Workload> all_workloads(std::size_t scale);

}  // namespace somato::bench
