#pragma once

#include <vector>

#include "somato/bodies/object.h"
#include "somato/bodies/scene.h"

namespace somato {

/// Finds the scenes of recordings of the simulated hands and probes and of devices (is_of_body()),
/// by their channels; see play_hand() and play_probes(). A hand has the object of the label
/// `object`: one of `own`, or of the built-in tables if a simulated body explored these
/// (is_of_built_in_things()), unless another label contradicts it or the object does not fit; the
/// hand is then shown without an object. For one thread: it caches the hands built last.
SceneFinder recorded_scenes(std::vector<Object> own = {});

}  // namespace somato
