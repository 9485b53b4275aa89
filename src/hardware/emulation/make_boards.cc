#include "hardware/emulation/make_boards.h"

#include "hardware/emulation/dynamixel_servos.h"
#include "hardware/emulation/feetech_servos.h"
#include "hardware/emulation/sensor_board.h"
#include "hardware/emulation/ssc32_board.h"

namespace somato::emulation {
namespace {

std::unique_ptr<EmulatedServos> ssc32_board(const devices::DeviceFile& file) {
  std::vector<int> channels;
  channels.reserve(file.servos.size());
  for (const devices::ServoSettings& servo : file.servos) {
    channels.push_back(static_cast<int>(servo.channel));
  }
  return std::make_unique<Ssc32Board>(std::move(channels));
}

template <typename Made>
std::vector<Made> made_servos(const devices::DeviceFile& file, std::uint16_t model) {
  std::vector<Made> servos;
  servos.reserve(file.servos.size());
  for (const devices::ServoSettings& servo : file.servos) {
    Made made;
    made.id = static_cast<std::uint8_t>(servo.channel);
    made.model = model;
    made.position = servo.on_bus(servo.resting());
    servos.push_back(made);
  }
  return servos;
}

std::unique_ptr<EmulatedServos> feetech_servos(const devices::DeviceFile& file,
                                               wire::FeetechSeries series, std::uint16_t model) {
  return std::make_unique<FeetechServos>(series, made_servos<EmulatedFeetech>(file, model));
}

}  // namespace

std::unique_ptr<EmulatedServos> make_servos(const devices::DeviceFile& file) {
  constexpr std::uint16_t kXc330 = 1240;
  constexpr std::uint16_t kSts3215 = 777;
  constexpr std::uint16_t kScs0009 = 1284;
  switch (file.servo_line->bus) {
    case devices::BusKind::kSsc32:
      return ssc32_board(file);
    case devices::BusKind::kDynamixel:
      return std::make_unique<DynamixelServos>(made_servos<EmulatedDynamixel>(file, kXc330));
    case devices::BusKind::kSts:
      return feetech_servos(file, wire::FeetechSeries::kSts, kSts3215);
    case devices::BusKind::kScs:
      break;
  }
  return feetech_servos(file, wire::FeetechSeries::kScs, kScs0009);
}

std::unique_ptr<EmulatedSensors> make_sensors(const devices::FrameLine& line) {
  SensorBoardSettings settings;
  settings.elements = line.elements;
  settings.rate = line.rate;
  settings.format = line.format;
  return std::make_unique<SensorBoard>(settings);
}

}  // namespace somato::emulation
