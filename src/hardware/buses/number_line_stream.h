#pragma once

#include "hardware/buses/sensor_stream.h"
#include "hardware/protocols/number_line.h"

namespace somato::devices {

/// A board that prints lines of numbers separated by commas. The format has neither numbers of
/// frames nor times.
class NumberLineStream : public SensorStream {
 public:
  explicit NumberLineStream(std::size_t values);

  void receive(std::span<const std::uint8_t> bytes, double now) override;

  std::size_t rejected() const override { return decoder_.rejected(); }

 private:
  wire::NumberLineDecoder decoder_;
};

}  // namespace somato::devices
