#pragma once

#include "somato/bodies/body.h"
#include "somato/bodies/frame_log.h"
#include "somato/core/parameter.h"
#include "somato/recording/recording.h"

namespace somato {

/// How a texture probe strokes: P11 section IV-A turns its lever by 36 degrees in 1 s.
struct StrokeParameters {
  double from = 0.0;
  double to = 36.0;
  double settle = 0.2;
  double step = 0.1;

  static const Declarations<StrokeParameters>& declarations();
};

/// Turns the body's `lever` to where the stroke starts, lets it settle, then strokes at its fastest
/// and records `sound` all the while: as many frames as its rate takes in that time, none from
/// before or after. The channel is the only one; labels are the caller's.
///
/// Errors: kUsage for a body without that degree of freedom or sensor, parameters out of range and
/// a stroke shorter than a frame; kData for a start or end beyond the lever's limits, a sensor
/// without a rate or with too few frames and a lever that does not arrive; what the body says, and
/// `after_frames`, which is called after each step of the stroke.
Result<Exploration> explore_by_stroking(Body& body, const StrokeParameters& parameters = {},
                                        const AfterFrames& after_frames = {});

}  // namespace somato
