#pragma once

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/layout.h"

namespace somato {

/// Whether recordings with this layout can be evaluated by a trained system: every module must have
/// the same output as in training. Errors name the channel or the module: those of
/// System::build(), and kData for another output.
Result<void> check_layout(const System& trained, const RecordingLayout& layout);

}  // namespace somato
