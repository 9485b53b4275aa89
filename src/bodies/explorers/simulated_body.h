#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "somato/bodies/body.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {

/// A simulated hand or probe before it explores a thing (counting from 0) of the table as trial
/// number `trial` (from 0): with the placement and the noise that simulated_explorer() would give
/// it with the same arguments. The materials of a probe's table are its things.
///
/// Errors (kUsage): kProbes and kAllSenses, which are several bodies; an unknown thing; those of
/// HandScene::build() and of the probes.
Result<std::unique_ptr<Body>> simulated_body(ExploringBody body, const ObjectTable& things,
                                             const ExploringParameters& parameters,
                                             std::uint64_t seed, std::size_t thing,
                                             std::size_t trial);

}  // namespace somato
