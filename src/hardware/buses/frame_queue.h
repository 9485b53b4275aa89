#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "recordings/explorations/growing_channel.h"
#include "somato/core/matrix.h"

namespace somato::devices {

/// The frames of a sensor line that have not been taken, each with its time. A closed queue, as it
/// is at first, keeps none.
///
/// Frames often arrive several at once. Where the board states times, the distances of the frames
/// are those of the board's clock, set so that no frame is later than its arrival; a clock that is
/// slow by up to a hundredth is followed. Otherwise the time of a frame is that of its arrival.
class FrameQueue {
 public:
  explicit FrameQueue(std::size_t values) : values_(values), waiting_(values) {}

  /// Opens the queue, and discards what it contains: it keeps the frames from `now` on.
  void begin(double now);

  /// Adds a frame that arrived at `now`, in seconds of the host's clock; `device_time` is the one
  /// of the board, in seconds of its own clock. Throws InvalidArgument for another number of
  /// values.
  void add(std::span<const float> values, double now, std::optional<double> device_time);

  /// Moves the frames up to the time `end` to `values` (frames x values) and `times`.
  void take(double end, Matrix<float>& values, std::vector<double>& times);

 private:
  double time_of(double now, std::optional<double> device_time);

  std::size_t values_;  // of a frame
  WaitingFrames waiting_;
  bool is_open_ = false;
  double begun_ = 0.0;
  double latest_ = -std::numeric_limits<double>::infinity();
  double ahead_ = std::numeric_limits<double>::infinity();  // the host's clock before the board's
  double device_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace somato::devices
