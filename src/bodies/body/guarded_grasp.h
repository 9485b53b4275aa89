#pragma once

#include <cstddef>
#include <vector>

#include "bodies/body/frame_log.h"
#include "bodies/body/hand_layout.h"
#include "somato/bodies/explore_by.h"

namespace somato {

/// The result of a grasp.
struct GraspResult {
  std::size_t iterations = 0;
  std::size_t touching = 0;  ///< Number of segments stopped by touch.
};

/// Closes the fingers of a hand whose servos were sent to `targets`, each by the papers' rule. Its
/// proximal segment closes step by step until the summed absolute change of the segment's taxels
/// since the start of the grasp exceeds the threshold, or until it is at its closed limit, the
/// maximum of its servo. Then its distal segment closes under the same rule, with the change of its
/// taxels relative to this moment. The grasp ends after the given number of still iterations after
/// the last segment; `log` receives the frames of each iteration, and `targets` become those of the
/// closed hand. Errors: kData if it takes more than the maximum number of iterations ("never
/// closed"), or if the sensor `touch` has no frame or too few elements; those of command() and
/// step().
Result<GraspResult> guarded_grasp(Body& body, const HandLayout& hand, const GuardedGrasp& grasp,
                                  std::vector<double>& targets, FrameLog& log);

}  // namespace somato
