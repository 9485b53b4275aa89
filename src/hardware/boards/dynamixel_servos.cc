#include "hardware/boards/dynamixel_servos.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "hardware/protocols/dynamixel.h"

namespace somato::emulation {
namespace {

namespace dynamixel_x = wire::dynamixel_x;
namespace dynamixel_error = wire::dynamixel_error;

constexpr ServoMemory kDynamixelMemory{
    .address_size = 2,
    .end = 228,
    .id = dynamixel_x::kId,
    .return_delay = dynamixel_x::kReturnDelay,
    .torque = dynamixel_x::kTorqueEnable,
    .goal = dynamixel_x::kGoalPosition,
    .goal_size = 4,
    .position = dynamixel_x::kPresentPosition,
    .temperature = dynamixel_x::kPresentTemperature,
    .measured = dynamixel_x::kPresentCurrent,
    .measured_size = 10,
    .access_error = dynamixel_error::kAccess,
    .sync_by_any_id = true,
    .boot = 0.3,
};

// Whether writing `size` bytes at `address` would reach one of [first, last].
bool touches(std::size_t address, std::size_t size, std::size_t first, std::size_t last) {
  return address <= last && address + size > first;
}

}  // namespace

DynamixelServos::DynamixelServos(const std::vector<EmulatedDynamixel>& servos, bool echo)
    : ServoChain(kDynamixelMemory, servos.size(), echo, std::make_unique<wire::DynamixelWriter>(),
                 std::make_unique<wire::DynamixelDecoder>()) {
  for (std::size_t i = 0; i < servos.size(); ++i) {
    current_units_.push_back(servos[i].current_unit);
    store(i, dynamixel_x::kModelNumber, 2, servos[i].model);
    store(i, dynamixel_x::kFirmware, 1, 46);
    store(i, dynamixel_x::kId, 1, servos[i].id);
    store(i, dynamixel_x::kReturnDelay, 1, servos[i].return_delay);
    store(i, dynamixel_x::kOperatingMode, 1, 3);
    store(i, dynamixel_x::kVelocityLimit, 4, 350);
    store(i, dynamixel_x::kMaxPosition, 4, 4095);
    store(i, dynamixel_x::kShutdown, 1, 52);
    DynamixelServos::set_measured(i, servos[i].position, 0.0);
    boot(servos_[i]);
  }
}

void DynamixelServos::set_defaults(Servo& servo) const {
  servo.memory[dynamixel_x::kStatusReturn] = 2;
}

void DynamixelServos::set_measured(std::size_t servo, double position, double current) {
  const auto count = static_cast<std::int16_t>(std::lround(current / current_units_.at(servo)));
  store(servo, dynamixel_x::kPresentCurrent, 2, static_cast<std::uint16_t>(count));
  const auto steps = static_cast<std::int32_t>(std::lround(position));
  store(servo, dynamixel_x::kPresentPosition, 4, static_cast<std::uint32_t>(steps));
}

void DynamixelServos::overload(std::size_t servo) {
  auto& memory = servos_.at(servo).memory;
  memory[dynamixel_x::kHardwareError] |= dynamixel_x::kOverload;
  if ((memory[dynamixel_x::kShutdown] & dynamixel_x::kOverload) != 0)
    memory[dynamixel_x::kTorqueEnable] = 0;
}

void DynamixelServos::obey_single(Servo& servo, const wire::Packet& packet) {
  const Instruction instruction = packet.instruction;
  const bool everyone = packet.id == wire::kEveryone;
  if (instruction == Instruction::kPing) {
    const std::array<std::uint8_t, 3> known{servo.memory[0], servo.memory[1],
                                            servo.memory[dynamixel_x::kFirmware]};
    return answer(servo, instruction, 0, known);
  }
  if (instruction == Instruction::kRead && packet.parameters.size() == 4) {
    if (!everyone) answer_read(servo, instruction, packet.parameters);
    return;
  }
  const std::uint8_t result = result_of(servo, packet);
  if (!everyone) answer(servo, instruction, result, {});
  if (instruction == Instruction::kReboot) reboot(servo);
}

std::uint8_t DynamixelServos::result_of(Servo& servo, const wire::Packet& packet) {
  const Span given = packet.parameters;
  if (packet.instruction == Instruction::kWrite && given.size() > 2) return write(servo, given);
  if (packet.instruction == Instruction::kRegWrite && given.size() > 2) {
    const std::uint8_t result = refusal(servo, number(given.first(2)), given.subspan(2));
    if (result == 0) servo.registered.assign(given.begin(), given.end());
    return result;
  }
  if (packet.instruction == Instruction::kAction && !servo.registered.empty()) {
    return write(servo, std::exchange(servo.registered, {}));
  }
  return packet.instruction == Instruction::kReboot ? 0 : dynamixel_error::kInstruction;
}

bool DynamixelServos::answers(const Servo& servo, Instruction to) const {
  const std::uint8_t level = servo.memory[dynamixel_x::kStatusReturn];
  const bool reads = to == Instruction::kRead || to == Instruction::kSyncRead;
  return to == Instruction::kPing || level >= (reads ? 1 : 2);
}

std::uint8_t DynamixelServos::error_bits(const Servo& servo) const {
  return servo.memory[dynamixel_x::kHardwareError] != 0 ? dynamixel_error::kAlert : 0;
}

std::uint8_t DynamixelServos::refusal(const Servo& servo, std::size_t address, Span data) const {
  const std::size_t size = data.size();
  const bool powered = servo.memory[dynamixel_x::kTorqueEnable] == 1;
  if (address + size > kDynamixelMemory.end || touches(address, size, 0, 6) ||
      touches(address, size, 69, 70) || touches(address, size, 120, 167) ||
      (powered && address < dynamixel_x::kTorqueEnable)) {
    return dynamixel_error::kAccess;
  }
  // The number at `item`, if the data contain it.
  const auto written = [&](std::size_t item, std::size_t bytes) -> std::optional<std::uint32_t> {
    if (address > item || address + size < item + bytes) return std::nullopt;
    return number(data.subspan(item - address, bytes));
  };
  if (const auto torque = written(dynamixel_x::kTorqueEnable, 1)) {
    if (*torque > 1) return dynamixel_error::kRange;
    if (*torque == 1 && error_bits(servo) != 0) return dynamixel_error::kResult;
  }
  const auto goal = written(dynamixel_x::kGoalPosition, 4);
  if (!goal || servo.memory[dynamixel_x::kOperatingMode] != 3) return 0;
  const auto steps = static_cast<std::int32_t>(*goal);
  const bool beyond = steps > position(servo, dynamixel_x::kMaxPosition) ||
                      steps < position(servo, dynamixel_x::kMinPosition);
  return beyond ? dynamixel_error::kLimit : 0;
}

void DynamixelServos::write_byte(Servo& servo, std::size_t address, std::uint8_t value) const {
  servo.memory[address] = value;
  if (address < dynamixel_x::kTorqueEnable) servo.kept[address] = value;
}

double DynamixelServos::position(const Servo& servo, std::uint16_t address) const {
  return static_cast<std::int32_t>(number(servo, address, 4));
}

// The profile without acceleration: rectangular, or a step.
double DynamixelServos::speed(const Servo& servo, double way) const {
  const double setting = number(servo, dynamixel_x::kVelocity, 4);
  const bool timed = (servo.memory[dynamixel_x::kDriveMode] & dynamixel_x::kTimeBasedProfile) != 0;
  return timed && setting > 0.0 ? way / (setting * 0.001) : setting * dynamixel_x::kVelocityUnit;
}

}  // namespace somato::emulation
