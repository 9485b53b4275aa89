#pragma once

#include <vector>

#include "somato/bodies/explore_by.h"

namespace somato {

/// The position of the hand for one grasp.
struct GraspPose {
  double height = 0.0;       ///< mm.
  double wrist_angle = 0.0;  ///< deg.

  bool operator==(const GraspPose&) const = default;
};

/// The poses of a plan: at the first height all wrist angles in order, at the next one in reverse
/// order, and so on, until there are `grasps` poses. Errors (kUsage): no height, no angle, no
/// grasp, more grasps than poses, a number out of range.
Result<std::vector<GraspPose>> grasp_poses(const ExplorationPlan& plan);

}  // namespace somato
