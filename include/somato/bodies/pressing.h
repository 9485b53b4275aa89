#pragma once

#include <cstddef>
#include <optional>

#include "somato/bodies/body.h"
#include "somato/bodies/frame_log.h"
#include "somato/core/parameter.h"
#include "somato/recording/recording.h"

namespace somato {

/// How a hardness probe presses: P11 section IV presses and reads at the end.
struct PressParameters {
  std::optional<double> to;
  double step = 0.05;
  std::size_t readings = 10;
  double patience = 20.0;

  static const Declarations<PressParameters>& declarations();
};

/// Sends the body's `stick` forward, waits until it has come to rest, and records the
/// `potentiometer` once: a channel of one frame, the only one; labels are the caller's.
///
/// It rests when the driver is done and, as many times in a row as there are readings in a mean,
/// the mean of the last readings differs from that of as many before by no more than three standard
/// errors, by the scatter between neighbouring readings, and a count. A stick that has reached the
/// end of its stroke rests too.
///
/// Errors: kUsage for a body without that degree of freedom or sensor and parameters out of range;
/// kData for a target beyond the stick's limits and a stick that does not come to rest before
/// patience ends; what the body says, and `after_frames`, which is called after each reading,
/// of which the last belongs to the exploration.
Result<Exploration> explore_by_pressing(Body& body, const PressParameters& parameters = {},
                                        const AfterFrames& after_frames = {});

}  // namespace somato
