#pragma once

#include <string>

#include "views/replay/played_exploration.h"
#include "views/session/view_json.h"
#include "views/teaching/kept_explorations.h"

namespace somato::live {

/// The names of a session, as docs/formats/view.md describes them: those of `label`, or of the
/// label "object" if that is empty. `played` is the current exploration, or nullptr.
Json naming_json(const KeptExplorations& kept, const PlayedExploration* played,
                 const std::string& label);

}  // namespace somato::live
