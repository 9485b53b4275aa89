#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/recording/recording.h"

namespace somato {

/// The time of a frame, of the `frames` that a sensor with this rate (Hz, or 0) gave in a step that
/// ended at `end`, in seconds.
inline double frame_time(std::size_t frame, std::size_t frames, double rate, double end) {
  const auto later = static_cast<double>(frames - 1 - frame);
  return later == 0.0 ? end : end - later / rate;
}

/// Appends frames to a channel with as many elements. A NaN is a reading that is missing: its value
/// is then 0, and the channel marks it.
void append_readings(Channel& channel, const Matrix<float>& frames);

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

  Result<void> append(Sensor& sensor, const Matrix<float>& frames, double end);
  void drop_all();

  std::vector<Sensor> sensors_;
  std::size_t most_;       // bytes
  std::size_t bytes_ = 0;  // of all frames so far
};

}  // namespace somato
