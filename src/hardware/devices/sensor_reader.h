#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "hardware/devices/device_io.h"
#include "somato/core/matrix.h"

namespace somato::devices {

/// The readings of a device's sensors, computed from what the lines gave. Nothing allocates after
/// prepare(), except for samples and for frames
/// of which every one is kept.
class SensorReader {
 public:
  explicit SensorReader(const DeviceFile& file);

  /// Gives `readings` one frame for each sensor, and none for a microphone.
  void prepare(std::vector<Matrix<float>>& readings) const;

  /// The latest frame of each sensor but the microphone; `positions` are those of the driver.
  void read(const DeviceIo& io, std::span<const double> positions,
            std::vector<Matrix<float>>& readings) const;

  /// The greatest magnitude among the latest values of a sensor; NaN counts as infinite.
  double greatest(std::string_view sensor, const DeviceIo& io,
                  std::span<const double> positions) const;

  /// The frames of the sensor line up to the time `end` of its queue, with their times from `start`
  /// on, for the sensors that have them.
  void take_frames(FrameQueue& queue, double start, double end, BodyState& state);

  /// The oldest `count` samples of the microphone.
  void take_samples(SampleQueue& samples, std::size_t count,
                    std::vector<Matrix<float>>& readings) const;

 private:
  struct Sensor {
    SensorSettings settings;
    std::vector<std::size_t> servos;  // Numbers of the servos that it reads.
    std::size_t elements = 1;
  };

  double value(const Sensor& sensor, std::size_t element, const DeviceIo& io,
               std::span<const double> positions) const;

  const std::vector<ServoSettings> servos_;
  std::vector<Sensor> sensors_;
  Matrix<float> taken_;
  std::vector<double> times_;
};

}  // namespace somato::devices
