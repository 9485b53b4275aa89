#pragma once

#include <vector>

#include "flags/command_line.h"
#include "views/skins/channel_places.h"

namespace somato::program {

/// --layout, with which `what` is drawn.
Flag layout_flag(const std::string& what);

/// The tables of its file; none without the flag. Errors: those of read_layout().
Result<std::vector<ChannelPlaces>> read_layout_flag(const Arguments& arguments);

}  // namespace somato::program
