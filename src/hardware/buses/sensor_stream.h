#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware/buses/frame_queue.h"

namespace somato::devices {

/// The values that a sensor board sends on its own over one serial line. It decodes bytes; nothing
/// allocates after its creation.
class SensorStream {
 public:
  SensorStream(const SensorStream&) = delete;
  SensorStream(SensorStream&&) = delete;
  SensorStream& operator=(const SensorStream&) = delete;
  SensorStream& operator=(SensorStream&&) = delete;
  virtual ~SensorStream() = default;

  /// Bytes that arrived at `now`.
  virtual void receive(std::span<const std::uint8_t> bytes, double now) = 0;

  /// The values of the last whole frame; NaN before the first, and where the format says that the
  /// board has no reading.
  std::span<const float> values() const { return values_; }

  /// The arrival of the last byte of the last whole frame, in seconds of the clock of
  /// receive(); -infinity before the first. It grows old when the board falls silent.
  double time() const { return time_; }

  /// The board's own clock at the last whole frame, in seconds; empty before the first, and if the
  /// format has no time. It goes back only when the board restarts.
  std::optional<double> device_time() const { return device_time_; }

  /// The frames that no one has taken; none unless the queue is open.
  FrameQueue& queue() { return queue_; }

  /// Whole frames so far.
  std::size_t frames() const { return frames_; }

  /// Frames that are missing in the sequence of numbers; 0 if the format has none.
  std::size_t lost() const { return lost_; }

  /// Pieces of the stream that were no valid frame.
  virtual std::size_t rejected() const = 0;

  /// The last of these pieces and why it was none, in words; empty without one.
  virtual std::string complaint() const = 0;

  /// The last line of a format of text, valid or not; empty for other formats.
  virtual std::string last_line() const { return {}; }

 protected:
  explicit SensorStream(std::size_t values)
      : values_(values, std::numeric_limits<float>::quiet_NaN()), queue_(values) {}

  /// The values are those of a whole frame, whose last byte arrived at `now`.
  void end_frame(double now, std::optional<double> device_time = {}) {
    time_ = now;
    device_time_ = device_time;
    ++frames_;
    queue_.add(values_, now, device_time);
  }

  std::vector<float> values_;
  std::size_t lost_ = 0;

 private:
  double time_ = -std::numeric_limits<double>::infinity();
  std::optional<double> device_time_;
  std::size_t frames_ = 0;
  FrameQueue queue_;
};

}  // namespace somato::devices
