#pragma once

#include "hardware/buses/sensor_stream.h"
#include "hardware/protocols/anyskin_frame.h"

namespace somato::devices {

/// AnySkin, ReSkin and eFlesh: the values are the fields x, y and z of each magnetometer in
/// microtesla, NaN for a magnetometer that has no reading. The format has neither numbers nor
/// times.
class AnySkinStream : public SensorStream {
 public:
  explicit AnySkinStream(std::size_t magnetometers, const wire::AnySkinLimits& limits = {});

  void receive(std::span<const std::uint8_t> bytes, double now) override;

  std::size_t rejected() const override { return decoder_.rejected(); }
  std::string complaint() const override { return decoder_.complaint(); }

  /// Degrees Celsius at each magnetometer; NaN before the first frame.
  std::span<const float> temperatures() const { return temperatures_; }

 private:
  wire::AnySkinDecoder decoder_;
  std::vector<float> temperatures_;
};

}  // namespace somato::devices
