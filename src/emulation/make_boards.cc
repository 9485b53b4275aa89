#include "emulation/make_boards.h"

#include "emulation/dynamixel_servos.h"
#include "somato/core/check.h"

namespace somato::emulation {
namespace {

std::unique_ptr<EmulatedServos> dynamixel_servos(const devices::DeviceFile& file) {
  std::vector<EmulatedDynamixel> servos;
  for (const devices::ServoSettings& servo : file.servos) {
    EmulatedDynamixel made;
    made.id = static_cast<std::uint8_t>(servo.channel);
    made.position = servo.on_bus(servo.resting());
    servos.push_back(made);
  }
  return std::make_unique<DynamixelServos>(std::move(servos));
}

}  // namespace

std::unique_ptr<EmulatedServos> make_servos(const devices::DeviceFile& file) {
  switch (file.servo_line->bus) {
    case devices::BusKind::kDynamixel:
      return dynamixel_servos(file);
    case devices::BusKind::kSsc32:
    case devices::BusKind::kSts:
    case devices::BusKind::kScs:
      break;
  }
  require(false, "bus");
  return nullptr;
}

std::unique_ptr<EmulatedSensors> make_sensors(const devices::FrameLine&) {
  require(false, "sensors");
  return nullptr;
}

}  // namespace somato::emulation
