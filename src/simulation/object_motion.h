#pragma once

#include <array>

#include "simulation/hand_scene.h"

namespace somato::detail {

/// Where a body is.
struct Pose {
  std::array<double, 3> position{};                ///< m.
  std::array<double, 4> turn{1.0, 0.0, 0.0, 0.0};  ///< A unit quaternion.
};

/// Where the object's footprint is to be, off the place where objects stand.
Pose object_pose(const HandScene::Parts& scene, const Placement& placement);

/// Puts the object there, and under a free round one what it lies on.
void put_object(const HandScene::Parts& scene, const Pose& pose, mjData& data);

/// Fails (kData) when a free object has left its place, fallen over or sunk.
Result<void> check_object(const HandScene::Parts& scene, const Pose& placed, const mjData& data);

/// Fails (kUsage) when the hand and the object overlap. The positions of all must be up to date.
Result<void> check_apart(const HandScene::Parts& scene, const mjData& data);

}  // namespace somato::detail
