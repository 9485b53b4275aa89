#pragma once

#include <cstddef>

#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::program {

/// The source of a demonstration as a recording of one of its explorations, counted from 0 in the
/// order of its plan, with its system trained on the explorations before the demonstration. Errors:
/// kUsage without such an exploration; those of exploring and training; kInterrupted.
Result<ViewSource> demonstrated_recording(ViewSource source, std::size_t exploration);

}  // namespace somato::program
