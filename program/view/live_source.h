#pragma once

#include <cstddef>
#include <memory>

#include "flags/command_line.h"
#include "somato/bodies/explorer.h"
#include "views/session/view_source.h"

namespace somato::program {

/// The explorations that `somato live` reads: those of --body or of --recording. Errors: kUsage for
/// flags without effect; those of the body, the objects and the recording.
Result<ViewSource> live_source(const Arguments& arguments);

/// A source of which `explorer`, any body, explores its things, each `explorations` times before
/// the next one; with --object only that thing. Errors (kUsage): no such thing; too many
/// explorations for a session.
Result<ViewSource> explorer_source(const Arguments& arguments, std::unique_ptr<Explorer> explorer);

}  // namespace somato::program
