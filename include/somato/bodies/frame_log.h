#pragma once

#include <functional>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/recording/recording.h"

namespace somato {

/// Called after each step whose frames belong to an exploration. An error ends it with that error.
using AfterFrames = std::function<Result<void>(const BodyState& state)>;

/// Keeps what a body felt during the steps that it is told of.
class FrameLog {
 public:
  explicit FrameLog(const BodyDescription& description, AfterFrames after_frames = {});

  /// Adds the frames that were taken during the last step. Errors (kData) name a sensor whose
  /// readings do not fit its description or those before; those of `after_frames`.
  Result<void> append(const BodyState& state);

  /// A channel for each sensor, with the time of each frame in seconds of the body's clock: a step
  /// that is left out leaves a gap, so that a sensor's rate alone would not tell when.
  std::vector<Channel> channels() &&;

 private:
  struct Sensor {
    Channel channel;
    double rate = 0.0;
    bool times_known = true;
    std::vector<float> values;
  };

  static Result<void> append(Sensor& sensor, const Matrix<float>& frames, double end);

  std::vector<Sensor> sensors_;
  AfterFrames after_frames_;
};

}  // namespace somato
