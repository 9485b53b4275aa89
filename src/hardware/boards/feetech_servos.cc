#include "hardware/boards/feetech_servos.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato::emulation {
namespace {

namespace feetech = wire::feetech;

ServoMemory feetech_memory(wire::FeetechSeries series) {
  return {
      .order = wire::feetech_order(series),
      .end = 87,
      .id = feetech::kId,
      .return_delay = feetech::kReturnDelay,
      .torque = feetech::kTorqueEnable,
      .goal = feetech::kGoalPosition,
      .goal_size = 2,
      .position = feetech::kPresentPosition,
      .temperature = feetech::kPresentTemperature,
      .measured = feetech::kPresentPosition,
      .measured_size = 15,
      .boot = 0.8,
  };
}

}  // namespace

FeetechServos::FeetechServos(wire::FeetechSeries series, const std::vector<EmulatedFeetech>& servos,
                             bool echo)
    : ServoChain(feetech_memory(series), servos.size(), echo,
                 std::make_unique<wire::FeetechWriter>(wire::feetech_order(series)),
                 std::make_unique<wire::FeetechDecoder>()),
      series_(series) {
  for (std::size_t i = 0; i < servos.size(); ++i) {
    store(i, feetech::kModel, 2, servos[i].model);
    store(i, feetech::kId, 1, servos[i].id);
    store(i, feetech::kReturnDelay, 1, servos[i].return_delay);
    store(i, feetech::kResponseLevel, 1, 1);
    store(i, feetech::kMaxPosition, 2, is_sts() ? 4095 : 1023);
    FeetechServos::set_measured(i, servos[i].position, 0.0);
    boot(servos_[i]);
  }
}

void FeetechServos::set_defaults(Servo& servo) const {
  servo.memory[feetech::kStatus] = 0;
  servo.memory[lock()] = 1;
}

void FeetechServos::set_measured(std::size_t servo, double position, double current) {
  const auto steps = static_cast<int>(std::lround(position));
  const int most = is_sts() ? 32767 : 1023;
  const int measured = std::clamp(steps, is_sts() ? -most : 0, most);
  store(servo, feetech::kPresentPosition, 2, wire::feetech_unsigned(measured));
  if (!is_sts()) return;
  const auto count = static_cast<int>(std::lround(current / feetech::kCurrentUnit));
  store(servo, feetech::kPresentCurrent, 2, wire::feetech_unsigned(count));
}

void FeetechServos::overload(std::size_t servo) {
  auto& memory = servos_.at(servo).memory;
  memory[feetech::kStatus] |= feetech::kOverload;
  memory[feetech::kTorqueEnable] = 0;
}

void FeetechServos::obey_single(Servo& servo, const wire::Packet& packet) {
  const Span given = packet.parameters;
  const bool everyone = packet.id == wire::kEveryone;
  switch (packet.instruction) {
    case Instruction::kPing:
      return answer(servo, packet.instruction, 0, {});
    case Instruction::kRead:
      if (!everyone && given.size() == 2) answer_read(servo, packet.instruction, given);
      return;
    case Instruction::kWrite:
      write(servo, given);
      break;
    case Instruction::kRegWrite:
      servo.registered.assign(given.begin(), given.end());
      break;
    case Instruction::kAction:
      write(servo, std::exchange(servo.registered, {}));
      break;
    case Instruction::kReboot:
      return reboot(servo);
    default:
      return;
  }
  if (!everyone) answer(servo, packet.instruction, 0, {});
}

// The servos of the SCS series do not know sync reads.
bool FeetechServos::answers(const Servo& servo, Instruction to) const {
  if (to == Instruction::kSyncRead) return is_sts();
  return to == Instruction::kPing || to == Instruction::kRead ||
         servo.memory[feetech::kResponseLevel] == 1;
}

std::uint8_t FeetechServos::error_bits(const Servo& servo) const {
  return servo.memory[feetech::kStatus];
}

void FeetechServos::write_byte(Servo& servo, std::size_t address, std::uint8_t value) const {
  const bool fixed = address < feetech::kId || address >= feetech::kPresentPosition;
  const bool failed = address == feetech::kTorqueEnable && error_bits(servo) != 0;
  if (fixed || (failed && value != 0)) return;
  servo.memory[address] = value;
  const bool locked = servo.memory[lock()] != 0;
  if (address < feetech::kTorqueEnable && !locked) servo.kept[address] = value;
}

double FeetechServos::position(const Servo& servo, std::uint16_t address) const {
  return wire::feetech_signed(static_cast<std::uint16_t>(number(servo, address, 2)));
}

double FeetechServos::limited_goal(const Servo& servo) const {
  const double goal = position(servo, feetech::kGoalPosition);
  const double lowest = number(servo, feetech::kMinPosition, 2);
  const double highest = number(servo, feetech::kMaxPosition, 2);
  return lowest < highest ? std::clamp(goal, lowest, highest) : goal;
}

// STS servos move with a speed; SCS servos also within a time.
double FeetechServos::speed(const Servo& servo, double way) const {
  const double milliseconds = is_sts() ? 0.0 : number(servo, feetech::kGoalTime, 2);
  return milliseconds > 0.0 ? way / (milliseconds * 0.001) : number(servo, feetech::kGoalSpeed, 2);
}

}  // namespace somato::emulation
