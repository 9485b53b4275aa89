#include "hardware/devices/device_io.h"

#include "hardware/buses/anyskin_stream.h"
#include "hardware/buses/number_line_stream.h"
#include "hardware/buses/sensor_frame_stream.h"

namespace somato::devices {
namespace {

// The names of the elements of all sensors of the frames; that of the sensor for its only one.
std::vector<wire::LineName> names_in_frames(const DeviceFile& file) {
  std::vector<wire::LineName> names;
  for (const SensorSettings& sensor : file.sensors) {
    if (sensor.from != SensorOrigin::kFrames) continue;
    if (sensor.elements.empty()) names.push_back({sensor.name, sensor.first});
    for (std::size_t i = 0; i < sensor.elements.size(); ++i) {
      names.push_back({sensor.elements[i], sensor.first + i});
    }
  }
  return names;
}

}  // namespace

std::unique_ptr<ServoBus> make_bus(const DeviceFile& file) {
  if (file.servos.empty()) return nullptr;
  return traits_of(file.servo_line->bus).bus(file.bus_servos());
}

std::vector<std::uint8_t> relax_bytes_of(const DeviceFile& file) {
  const std::unique_ptr<ServoBus> bus = make_bus(file);
  if (!bus) return {};
  return {bus->relax_bytes().begin(), bus->relax_bytes().end()};
}

std::unique_ptr<SensorStream> make_stream(const DeviceFile& file) {
  const FrameLine& line = *file.frame_line;
  switch (line.format) {
    case FrameFormat::kFrames:
      return std::make_unique<SensorFrameStream>(line.elements);
    case FrameFormat::kLines:
      return std::make_unique<NumberLineStream>(line.elements, names_in_frames(file));
    case FrameFormat::kAnyskin:
      break;
  }
  return std::make_unique<AnySkinStream>(line.elements / kAnyskinAxes);
}

}  // namespace somato::devices
