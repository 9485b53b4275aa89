#pragma once

#include <array>

#include "bodies/hands/hand_scene.h"

namespace somato::detail {

/// The pose of a body.
struct Pose {
  std::array<double, 3> position{};                ///< m.
  std::array<double, 4> turn{1.0, 0.0, 0.0, 0.0};  ///< A unit quaternion.
};

/// The target position of the object's footprint, relative to the site of the object.
Pose object_pose(const HandScene::Impl& scene, const Placement& placement);

/// Moves the object there, and for a free round one also its stand.
void put_object(const HandScene::Impl& scene, const Pose& pose, mjData& data);

/// Fails (kData) when a free object has left its place, fallen over or sunk.
Result<void> check_object(const HandScene::Impl& scene, const Pose& placed, const mjData& data);

/// Fails (kUsage) when the hand and the object overlap. The positions of all must be up to date.
Result<void> check_apart(const HandScene::Impl& scene, const mjData& data);

}  // namespace somato::detail
