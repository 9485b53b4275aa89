#include "hardware/devices/device_io.h"

#include "hardware/buses/anyskin_stream.h"
#include "hardware/buses/dynamixel_bus.h"
#include "hardware/buses/feetech_bus.h"
#include "hardware/buses/number_line_stream.h"
#include "hardware/buses/sensor_frame_stream.h"
#include "hardware/buses/ssc32_bus.h"

namespace somato::devices {
namespace {

std::unique_ptr<ServoBus> ssc32_bus(const DeviceFile& file) {
  std::vector<int> channels;
  channels.reserve(file.servos.size());
  for (const ServoSettings& servo : file.servos)
    channels.push_back(static_cast<int>(servo.channel));
  return std::make_unique<Ssc32Bus>(std::move(channels));
}

std::vector<PacketServo> packet_servos(const DeviceFile& file, const char* model) {
  std::vector<PacketServo> servos;
  servos.reserve(file.servos.size());
  for (const ServoSettings& servo : file.servos) {
    servos.push_back({static_cast<std::uint8_t>(servo.channel), model});
  }
  return servos;
}

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
  switch (file.servo_line->bus) {
    case BusKind::kSsc32:
      return ssc32_bus(file);
    case BusKind::kDynamixel:
      return std::make_unique<DynamixelBus>(packet_servos(file, ""));
    case BusKind::kSts:
      return std::make_unique<FeetechBus>(packet_servos(file, "STS"));
    case BusKind::kScs:
      break;
  }
  return std::make_unique<FeetechBus>(packet_servos(file, "SCS"));
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
