#pragma once

#include <vector>

#include "hardware/buses/sensor_stream.h"
#include "hardware/protocols/number_line.h"

namespace somato::devices {

/// A board that prints lines of numbers. The format has neither numbers of
/// frames nor times.
class NumberLineStream : public SensorStream {
 public:
  explicit NumberLineStream(std::size_t values, const std::vector<wire::LineName>& names = {});

  void receive(std::span<const std::uint8_t> bytes, double now) override;

  std::size_t rejected() const override { return decoder_.rejected(); }
  std::string complaint() const override { return decoder_.complaint(); }
  std::string last_line() const override { return decoder_.last_line(); }

 private:
  wire::NumberLineDecoder decoder_;
};

}  // namespace somato::devices
