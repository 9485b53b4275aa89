#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// What a T-MPSOM receives at once: one signal an input.
using TMpsomFrame = std::vector<Signal>;

/// The frames of one exploration, in the order of time.
using TMpsomExploration = std::vector<TMpsomFrame>;

/// Trains `map` for `iterations` iterations, one a frame: explorations are drawn at random with
/// replacement (Random(seed, Stream::kDraws); with or without replacement is not given in the
/// paper) and their frames learned one after the other, the last exploration as far as iterations
/// are left (P06 section 4.2). The learning rate is parameters().learning_rate().
///
/// Returns the number of iterations in which something was learned. Errors: no explorations, an
/// exploration without frames, a frame that does not fit the map or is not finite (kData, before
/// anything is learned); `progress` returned false (kInterrupted: the map is then as it was after
/// the iterations done).
Result<std::uint64_t> train_t_mpsom(TMpsom& map, std::span<const TMpsomExploration> explorations,
                                    const Progress& progress = {});

}  // namespace somato
