#pragma once

#include <vector>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::program {

/// The flags --render and --exploration.
std::vector<Flag> rendering_flags();

/// Errors (kUsage): --exploration without --render, a file that is neither WebM nor PNG, flags
/// without effect.
Result<void> check_rendering(const Arguments& arguments);

/// Draws an exploration of the source, a recording or a demonstration, as it stands in the view,
/// without a window, and saves it: a film, or a picture of its strongest touch. Errors: kUsage
/// without such an exploration; those of demonstrated_recording(), the server, HeadlessBrowser and
/// Film; kInterrupted.
Result<void> render_view(const Arguments& arguments, ViewSource source);

}  // namespace somato::program
