#pragma once

#include <cstddef>
#include <functional>

#include "somato/bodies/exploration_plan.h"
#include "somato/bodies/guarded_grasp.h"
#include "somato/recording/recording.h"

namespace somato {

/// Called when a grasp (counting from 0) has closed, before the hand opens.
using AfterGrasp = std::function<Result<void>(std::size_t grasp)>;

/// Explores by grasping from each pose of the plan: the fingers open, the servos `height` (mm) and
/// `wrist` (deg) go there, the hand grasps, and opens again. The channels are the body's sensors
/// with the frames of the grasps' iterations alone, at the times of the body's clock; there are no
/// labels.
/// Errors: those of the parts, of `after_grasp` and `after_frames`, naming the grasp; kData when no
/// segment of any grasp was stopped by what it felt: the hand never touched the object.
Result<Exploration> explore_by_grasping(Body& body, const ExplorationPlan& plan,
                                        const GuardedGrasp& grasp,
                                        const AfterGrasp& after_grasp = {},
                                        const AfterFrames& after_frames = {});

}  // namespace somato
