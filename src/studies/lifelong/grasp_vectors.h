#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/recording/recording.h"

namespace somato {

/// Which channels state the pose of a grasp, and which are read at its end.
struct GraspChannels {
  std::vector<std::string> pose;
  double tolerance = 0.5;  ///< In the unit of each channel of the pose.
  std::vector<std::string> read;
};

/// The grasps of each exploration: a sample per exploration for each grasp, in the order of the
/// recording. A grasp ends before the first frame in which a channel of the pose differs from its
/// first frame by more than `tolerance`; its vector consists of the channels `read` in its last
/// frame. Errors: an unknown channel (kUsage); channels that are not recorded together, or
/// explorations that do not have the same grasps in the same order (kData).
Result<std::vector<Samples>> grasp_vectors(const Recording& recording,
                                           const GraspChannels& channels);

}  // namespace somato
