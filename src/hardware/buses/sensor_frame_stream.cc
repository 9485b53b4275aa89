#include "hardware/buses/sensor_frame_stream.h"

#include <algorithm>

namespace somato::devices {
namespace {

// Half of the range: what is further ahead lies behind.
constexpr std::uint32_t kBehindInTime = 0x80000000;
constexpr std::uint16_t kBehindInSequence = 0x8000;

}  // namespace

SensorFrameStream::SensorFrameStream(std::size_t values) : SensorStream(values), decoder_(values) {}

void SensorFrameStream::receive(std::span<const std::uint8_t> bytes, double now) {
  for (const std::uint8_t byte : bytes) {
    if (decoder_.take(byte)) take(decoder_.frame(), now);
  }
}

void SensorFrameStream::take(const wire::SensorFrame& frame, double now) {
  if (frames() == 0) {
    microseconds_ = frame.microseconds;
  } else {
    follow(frame);
  }
  sequence_ = frame.sequence;
  std::copy(frame.values.begin(), frame.values.end(), values_.begin());
  end_frame(now, static_cast<double>(microseconds_) * 1e-6);
}

void SensorFrameStream::follow(const wire::SensorFrame& frame) {
  const auto passed = frame.microseconds - static_cast<std::uint32_t>(microseconds_);
  const auto missing = static_cast<std::uint16_t>(frame.sequence - sequence_ - 1);
  if (passed >= kBehindInTime || missing >= kBehindInSequence) {
    ++restarts_;
    microseconds_ = frame.microseconds;
  } else {
    microseconds_ += passed;
    lost_ += missing;
  }
}

}  // namespace somato::devices
