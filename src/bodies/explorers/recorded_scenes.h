#pragma once

#include <vector>

#include "somato/bodies/object.h"
#include "somato/bodies/scene.h"

namespace somato {

/// Finds the scenes of recordings of the simulated hands and probes, by their channels; see
/// play_hand() and play_probes(). A hand has the object of the label `object`: one of `own`, or
/// else of the built-in tables, unless another label contradicts it or the object does not fit; the
/// hand is then shown without an object. For one thread: it caches the hands built last.
SceneFinder recorded_scenes(std::vector<Object> own = {});

}  // namespace somato
