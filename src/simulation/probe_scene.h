#pragma once

#include <vector>

#include "somato/bodies/material.h"
#include "somato/bodies/scene.h"

namespace somato::detail {

/// Simple pictures of the probes, on a slab in the colour of their material. They are twice as
/// large as they are, for they are small.
Scene texture_probe_scene(const Material& material);
Scene hardness_probe_scene(const Material& material);

/// A pose for each body of those scenes: the lever at `degrees`, the stick at `millimetres`.
std::vector<ScenePose> texture_probe_poses(double degrees);
std::vector<ScenePose> hardness_probe_poses(double millimetres);

}  // namespace somato::detail
