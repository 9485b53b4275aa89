#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/files/archive.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// Puts a T-MPSOM into an archive: the text `PREFIXparameters` (TOML, every parameter) and for each
/// input the array `PREFIXweights_0`, `PREFIXweights_1`, ... (float32, neurons x elements).
void add_t_mpsom(Archive& archive, const std::string& prefix, const TMpsom& map);

/// The map that add_t_mpsom put there, bit by bit. Errors (kData, at `where`): parts missing or of
/// another type, parameters that are unknown, out of range or contradict each other, weights that
/// do not fit them or are not finite.
Result<TMpsom> t_mpsom_from(const Archive& archive, const std::string& prefix,
                            const std::string& where);

}  // namespace somato
