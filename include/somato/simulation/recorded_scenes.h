#pragma once

#include <vector>

#include "somato/bodies/object.h"
#include "somato/bodies/scene.h"

namespace somato {

/// Finds what recordings of the simulated hands and probes looked like, by their channels; see
/// play_hand() and play_probes(). A hand has the object of the label `object`: one of `own`, or
/// else of the tables that travel with the library, unless another label tells of another thing or
/// the object does not fit; then the hand is alone. For one thread: it keeps the hands built last.
SceneFinder recorded_scenes(std::vector<Object> own = {});

}  // namespace somato
