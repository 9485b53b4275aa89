#include "hardware/devices/sensor_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace somato::devices {

SensorReader::SensorReader(const DeviceFile& file) : servos_(file.servos) {
  for (const SensorSettings& settings : file.sensors) {
    Sensor sensor{settings, {}, elements_of(settings)};
    for (const std::string& name : settings.servos) {
      const auto servo = std::find_if(servos_.begin(), servos_.end(),
                                      [&](const ServoSettings& one) { return one.name == name; });
      sensor.servos.push_back(static_cast<std::size_t>(servo - servos_.begin()));
    }
    sensors_.push_back(std::move(sensor));
  }
}

void SensorReader::prepare(std::vector<Matrix<float>>& readings) const {
  readings.clear();
  for (const Sensor& sensor : sensors_) {
    const bool is_sound = sensor.settings.from == SensorOrigin::kMicrophone;
    readings.emplace_back(is_sound ? 0 : 1, sensor.elements);
  }
}

double SensorReader::value(const Sensor& sensor, std::size_t element, const DeviceIo& io,
                           std::span<const double> positions) const {
  const auto servo = [&] { return sensor.servos[element]; };
  switch (sensor.settings.from) {
    case SensorOrigin::kDriver:
      return positions[servo()];
    case SensorOrigin::kServos:
      return servos_[servo()].from_bus(io.reports()[servo()].position);
    case SensorOrigin::kCurrents:
      return io.reports()[servo()].current;
    case SensorOrigin::kFrames:
      return static_cast<double>(io.stream()->values()[sensor.settings.first + element]);
    case SensorOrigin::kMicrophone:
      break;
  }
  return 0.0;
}

void SensorReader::read(const DeviceIo& io, std::span<const double> positions,
                        std::vector<Matrix<float>>& readings) const {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const Sensor& sensor = sensors_[i];
    if (sensor.settings.from == SensorOrigin::kMicrophone) continue;
    if (readings[i].rows() != 1) readings[i] = Matrix<float>(1, sensor.elements);
    for (std::size_t element = 0; element < sensor.elements; ++element) {
      const double given = value(sensor, element, io, positions);
      readings[i](0, element) = sensor.settings.read(given);
    }
  }
}

double SensorReader::greatest(std::string_view name, const DeviceIo& io,
                              std::span<const double> positions) const {
  double greatest = 0.0;
  for (const Sensor& sensor : sensors_) {
    if (sensor.settings.name != name || sensor.settings.from == SensorOrigin::kMicrophone) continue;
    for (std::size_t element = 0; element < sensor.elements; ++element) {
      const double given = value(sensor, element, io, positions);
      const bool is_reported = sensor.settings.from == SensorOrigin::kFrames || !std::isnan(given);
      if (!is_reported) continue;  // A servo that has not reported yet; its silence is a fault.
      const double size = std::abs(sensor.settings.offset + sensor.settings.gain * given);
      if (std::isnan(size)) return std::numeric_limits<double>::infinity();
      greatest = std::max(greatest, size);
    }
  }
  return greatest;
}

void SensorReader::take_frames(FrameQueue& queue, double start, double end, BodyState& state) {
  queue.take(end, taken_, times_);
  for (double& time : times_) time -= start;
  state.times.resize(sensors_.size());
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const Sensor& sensor = sensors_[i];
    if (sensor.settings.from != SensorOrigin::kFrames) continue;
    state.readings[i] = Matrix<float>(taken_.rows(), sensor.elements);
    state.times[i] = times_;
    for (std::size_t frame = 0; frame < taken_.rows(); ++frame) {
      for (std::size_t element = 0; element < sensor.elements; ++element) {
        const double given = taken_(frame, sensor.settings.first + element);
        state.readings[i](frame, element) = sensor.settings.read(given);
      }
    }
  }
}

void SensorReader::take_samples(SampleQueue& samples, std::size_t count,
                                std::vector<Matrix<float>>& readings) const {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const SensorSettings& settings = sensors_[i].settings;
    if (settings.from != SensorOrigin::kMicrophone) continue;
    readings[i] = Matrix<float>(count, 1);
    samples.take(readings[i].values());
    for (float& value : readings[i].values()) {
      value = settings.read(static_cast<double>(value));
    }
  }
}

}  // namespace somato::devices
