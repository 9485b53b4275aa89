#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"

namespace somato::program {

/// The channels of a recording must be those of the training data. Errors (kData) name `place`.
Result<void> check_fit(const System& system, const Recording& recording, const std::string& place);

/// The same for a recording with that layout.
Result<void> check_fit(const System& system, const RecordingLayout& layout,
                       const std::string& place);

/// The same for the channels of a body, whose exploration begins.
Result<void> check_body_fit(const System& system, const Exploration& begun,
                            const std::string& place);

}  // namespace somato::program
