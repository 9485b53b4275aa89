#pragma once

#include <cstddef>
#include <vector>

#include "somato/bodies/frame_log.h"
#include "somato/bodies/hand_layout.h"
#include "somato/bodies/motion.h"
#include "somato/core/parameter.h"

namespace somato {

/// How a hand closes round what it feels (P06). None of the numbers is given in the paper.
struct GuardedGrasp {
  double iteration = 0.1;      ///< Seconds of a step of all fingers.
  double proximal_step = 1.5;  ///< deg an iteration.
  double distal_step = 4.0;    ///< deg an iteration.
  double threshold = 1.0;      ///< Summed change of a segment's taxels, in their unit.
  std::size_t still_iterations = 3;
  std::size_t most_iterations = 200;
  double proximal_open = 0.0;  ///< deg.
  double distal_open = -75.0;  ///< deg.
  Motion motion;               ///< Between grasps.

  static const Declarations<GuardedGrasp>& declarations();
};

/// What came of a grasp.
struct GraspResult {
  std::size_t iterations = 0;
  std::size_t touching = 0;  ///< How many segments were stopped by what they felt.
};

/// Closes the fingers of a hand whose servos were sent to `targets`, each by the papers' rule. Its
/// proximal segment closes step by step until the summed absolute change of the segment's taxels
/// since the start of the grasp exceeds the threshold, or it stands at its closed limit, the most
/// that its servo can do. Then its distal segment closes under the same rule, its taxels' change
/// counting from there on. The grasp ends so many still iterations after the last segment; `log`
/// gets the frames of each iteration, and `targets` become those of the closed hand.
/// Errors: kData when it takes more than the most iterations ("never closed"), or when the sensor
/// `touch` has no frame or too few elements; those of command() and step().
Result<GraspResult> guarded_grasp(Body& body, const HandLayout& hand, const GuardedGrasp& grasp,
                                  std::vector<double>& targets, FrameLog& log);

}  // namespace somato
