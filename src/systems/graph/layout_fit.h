#pragma once

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/layout.h"

namespace somato {

/// Whether recordings with this layout can be evaluated by a trained system: every module must have
/// the same output as in training, and the channels that it reads the same unit and elements, as
/// far as both are stated. Errors name the channel or the module: those of System::build(), and
/// kData for another output, unit or list of elements.
Result<void> check_layout(const System& trained, const RecordingLayout& layout);

}  // namespace somato
