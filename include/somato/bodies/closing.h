#pragma once

#include <cstddef>

#include "somato/bodies/frame_log.h"
#include "somato/bodies/motion.h"
#include "somato/core/parameter.h"
#include "somato/recording/recording.h"

namespace somato {

/// How a whole hand closes until its fingers rest on what they hold, as LUCS Haptic Hand III does
/// (P11). None of the numbers is given in the paper.
struct Closing {
  double iteration = 0.1;  ///< Seconds between frames.
  double share = 1.0;      ///< Of each servo's greatest speed.
  double still = 1.0;      ///< deg; no joint moves more than this while the hand is still.
  std::size_t still_iterations = 5;
  double longest = 10.0;  ///< Seconds.
  Motion motion;          ///< Before it closes.

  static const Declarations<Closing>& declarations();
};

/// Explores by closing the hand once: all servos but `wrist` and `height` go to their least, the
/// open hand; then, at the declared share of their speed, towards their most, until the driver has
/// taken all of them there, whether or not an object stops them, and the elements of the sensor
/// `joints` have moved from the open hand and then stayed within `still` deg for the still
/// iterations. The channels are the body's sensors with the frames of the closing, at the
/// times of the body's clock; there are no labels.
/// Errors: kData when it takes longer than the longest time ("never closed"), or when `joints`
/// gives no frame; kUsage for a body without a sensor `joints` or without fingers; those of
/// move_to() and of `after_frames`.
Result<Exploration> explore_by_closing(Body& body, const Closing& closing,
                                       const AfterFrames& after_frames = {});

}  // namespace somato
