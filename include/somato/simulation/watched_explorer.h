#pragma once

#include <cstdint>
#include <memory>

#include "somato/bodies/watched_body.h"
#include "somato/core/result.h"
#include "somato/simulation/explorer.h"

namespace somato {

/// A simulated body that explores before everybody's eyes, as Explorer does, but for the placement,
/// which is the caller's. Errors: those of Explorer::build() for a probe; kUsage for a body that is
/// more than one.
Result<std::unique_ptr<WatchedBody>> watch_body(ExploringBody body, const ObjectTable& things,
                                                const ExploringParameters& parameters,
                                                std::uint64_t seed);

}  // namespace somato
