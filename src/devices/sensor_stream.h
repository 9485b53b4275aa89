#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace somato::devices {

/// The frames of a sensor board, decoded as they arrive.
class SensorStream {
 public:
  SensorStream() = default;
  SensorStream(const SensorStream&) = delete;
  SensorStream(SensorStream&&) = delete;
  SensorStream& operator=(const SensorStream&) = delete;
  SensorStream& operator=(SensorStream&&) = delete;
  virtual ~SensorStream() = default;

  virtual void receive(std::span<const std::uint8_t> bytes, double now) = 0;
  virtual std::span<const float> values() const = 0;
  virtual double time() const = 0;
  virtual std::optional<double> device_time() const = 0;
  virtual std::uint64_t frames() const = 0;
  virtual std::uint64_t lost() const = 0;
  virtual std::uint64_t rejected() const = 0;
};

}  // namespace somato::devices
