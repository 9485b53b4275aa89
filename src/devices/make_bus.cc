#include "devices/device_io.h"
#include "devices/dynamixel_bus.h"
#include "somato/core/check.h"

namespace somato::devices {
namespace {

std::unique_ptr<ServoBus> dynamixel_bus(const DeviceFile& file) {
  std::vector<DynamixelServo> servos;
  for (const ServoSettings& servo : file.servos) {
    servos.push_back({static_cast<std::uint8_t>(servo.channel), {}});
  }
  return std::make_unique<DynamixelBus>(std::move(servos));
}

}  // namespace

std::unique_ptr<ServoBus> make_bus(const DeviceFile& file) {
  if (file.servos.empty()) return nullptr;
  switch (file.servo_line->bus) {
    case BusKind::kDynamixel:
      return dynamixel_bus(file);
    case BusKind::kSsc32:
    case BusKind::kSts:
    case BusKind::kScs:
      break;
  }
  require(false, "bus");
  return nullptr;
}

std::unique_ptr<SensorStream> make_stream(const FrameLine&) {
  require(false, "stream");
  return nullptr;
}

}  // namespace somato::devices
