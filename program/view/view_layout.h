#pragma once

#include "flags/command_line.h"
#include "views/session/view_source.h"

namespace somato::program {

/// Gives the source the places of --layout. Errors: those of read_layout(), and for a recording
/// those of check_channels() and places_for(); the channels of a body are checked when it explores.
Result<void> add_layout(const Arguments& arguments, ViewSource& source);

}  // namespace somato::program
