#pragma once

#include "hardware/buses/sensor_stream.h"
#include "hardware/protocols/sensor_frame.h"

namespace somato::devices {

/// A board that sends our own frames, with numbers, times and checksums. The board's clock is
/// unwrapped, provided that no pause exceeds 35 minutes. A clock that went back, or a number that
/// did, shows that the board restarted: then no frames count as lost, and its time begins anew.
class SensorFrameStream : public SensorStream {
 public:
  explicit SensorFrameStream(std::size_t values);

  void receive(std::span<const std::uint8_t> bytes, double now) override;

  std::size_t rejected() const override { return decoder_.rejected(); }
  std::string complaint() const override { return decoder_.complaint(); }

  /// The number of restarts of the board.
  std::size_t restarts() const { return restarts_; }

 private:
  void take(const wire::SensorFrame& frame, double now);
  void follow(const wire::SensorFrame& frame);

  wire::SensorFrameDecoder decoder_;
  std::uint64_t microseconds_ = 0;  // Unwrapped.
  std::uint16_t sequence_ = 0;
  std::size_t restarts_ = 0;
};

}  // namespace somato::devices
