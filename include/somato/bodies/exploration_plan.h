#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Where the hand is for one grasp.
struct GraspPose {
  double height = 0.0;       ///< mm.
  double wrist_angle = 0.0;  ///< deg.

  bool operator==(const GraspPose&) const = default;
};

/// From where an object is grasped: nine grasps at two heights and five wrist angles (P06). Which
/// nine of the ten, and in which order, is not given in the paper.
struct ExplorationPlan {
  std::vector<double> heights{126.0, 148.0};                        ///< mm.
  std::vector<double> wrist_angles{-48.0, -24.0, 0.0, 24.0, 48.0};  ///< deg.
  std::size_t grasps = 9;

  static const Declarations<ExplorationPlan>& declarations();
};

/// The poses of a plan: at the first height all wrist angles in their order, at the next one back,
/// and so on, until there are `grasps` of them. Errors (kUsage): no height, no angle, no grasp,
/// more grasps than poses, a number out of range.
Result<std::vector<GraspPose>> grasp_poses(const ExplorationPlan& plan);

}  // namespace somato
