#pragma once

#include <string>
#include <vector>

#include "bodies/probes/probe.h"
#include "somato/bodies/scene.h"

namespace somato::detail {

/// A simple picture of the probes, on a slab in the colour of their material. They are twice as
/// large as they are, for they are small.
Scene probe_scene(Probe probe, const std::string& material);

/// The poses of the probes.
struct ProbePlace {
  double lever = 0.0;  ///< deg.
  double stick = 0.0;  ///< mm.
};

/// A pose for each body of that scene.
std::vector<ScenePose> probe_poses(Probe probe, const ProbePlace& place);

}  // namespace somato::detail
