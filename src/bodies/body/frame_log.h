#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/recording/recording.h"

namespace somato {

/// The times of the frames that a sensor gave in a step, in seconds of the body's clock: its own,
/// or evenly spaced at its rate up to the end of the step.
class FrameTimes {
 public:
  /// `rate` is that of the sensor in Hz, or 0. `state` must outlive it.
  FrameTimes(const BodyState& state, std::size_t sensor, double rate);

  /// Whether each frame has a time.
  bool are_complete() const;

  /// The time of a frame; they must be complete.
  double operator[](std::size_t frame) const;

 private:
  std::size_t frames_;
  std::span<const double> own_;
  double rate_;
  double end_;
};

/// Collects the readings of a body during selected steps.
class FrameLog {
 public:
  /// Above `most` bytes of frames, all are dropped: the observer of the body has received them.
  explicit FrameLog(const BodyDescription& description,
                    std::size_t most = std::numeric_limits<std::size_t>::max());

  /// Adds the frames of the last step, as append_readings(). Errors (kData) name a sensor whose
  /// readings do not fit its description or the previous ones.
  Result<void> append(const BodyState& state);

  /// A channel for each sensor, with the time of each frame in seconds of the body's clock: an
  /// omitted step leaves a gap, so that the times are not determined by a sensor's rate. Without
  /// frames if they took more memory than permitted.
  std::vector<Channel> channels() &&;

 private:
  struct Sensor {
    Channel channel;
    double rate = 0.0;
    bool times_known = true;
  };

  Result<void> append(Sensor& sensor, const Matrix<float>& frames, const FrameTimes& times);
  void drop_all();

  std::vector<Sensor> sensors_;
  std::size_t most_;       // bytes
  std::size_t bytes_ = 0;  // of all frames so far
};

}  // namespace somato
