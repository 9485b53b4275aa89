#pragma once

#include <string>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// Adds a T-MPSOM to an archive: the text `PREFIXparameters` (TOML, every parameter) and for each
/// input the array `PREFIXweights_0`, `PREFIXweights_1`, ... (float32, neurons x elements).
void add_t_mpsom(Archive& archive, const std::string& prefix, const TMpsom& map);

/// Reads the map written by add_t_mpsom, bit by bit. Errors (kData, at `where`): parts that are
/// missing or of another type; parameters that are unknown, out of range or contradictory; weights
/// that do not fit them or are not finite.
Result<TMpsom> t_mpsom_from(const Archive& archive, const std::string& prefix,
                            const std::string& where);

}  // namespace somato
