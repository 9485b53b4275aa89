#include "hardware/emulation/dynamixel_servos.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/core/check.h"

namespace somato::emulation {
namespace {

namespace dynamixel_x = wire::dynamixel_x;
namespace dynamixel_error = wire::dynamixel_error;

constexpr double kDynamixelBoot = 0.3;        // s until a servo that was switched on answers
constexpr std::uint16_t kDynamixelEnd = 228;  // of the control table

std::uint32_t dynamixel_number(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) value = value << 8 | bytes[i - 1];
  return value;
}

std::int32_t dynamixel_signed(std::span<const std::uint8_t> bytes) {
  return static_cast<std::int32_t>(dynamixel_number(bytes));
}

void put_dynamixel_number(std::span<std::uint8_t> bytes, std::uint32_t value) {
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(value & 0xFF);
    value >>= 8;
  }
}

// Whether writing `size` bytes at `address` would reach one of [first, last].
bool touches(std::size_t address, std::size_t size, std::size_t first, std::size_t last) {
  return address <= last && address + size > first;
}

// The number of `size` bytes at `item`, if `data` written at `address` contain it.
std::optional<std::uint32_t> written_to(std::uint16_t item, std::size_t size, std::uint16_t address,
                                        std::span<const std::uint8_t> data) {
  if (address > item || address + data.size() < item + size) return std::nullopt;
  return dynamixel_number(data.subspan(item - std::size_t{address}, size));
}

// The status return level from which the instruction is answered.
std::uint8_t answering_level(wire::DynamixelInstruction instruction) {
  if (instruction == wire::DynamixelInstruction::kPing) return 0;
  return instruction == wire::DynamixelInstruction::kRead ||
                 instruction == wire::DynamixelInstruction::kSyncRead
             ? 1
             : 2;
}

}  // namespace

DynamixelServos::DynamixelServos(const std::vector<EmulatedDynamixel>& servos, bool echo)
    : echo_(echo) {
  for (const EmulatedDynamixel& made : servos) servos_.emplace_back().made = made;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    store(i, dynamixel_x::kModelNumber, 2, servos_[i].made.model);
    store(i, dynamixel_x::kFirmware, 1, 46);
    store(i, dynamixel_x::kId, 1, servos_[i].made.id);
    store(i, dynamixel_x::kReturnDelay, 1, servos_[i].made.return_delay);
    store(i, dynamixel_x::kOperatingMode, 1, 3);
    store(i, dynamixel_x::kVelocityLimit, 4, 350);
    store(i, dynamixel_x::kMaxPosition, 4, 4095);
    store(i, dynamixel_x::kShutdown, 1, 52);
    DynamixelServos::set_measured(i, servos_[i].made.position, 0.0);
    boot(servos_[i]);
  }
}

// The goal of a servo that boots is not documented: 0 moves it, unless the host writes one first.
void DynamixelServos::boot(Servo& servo) const {
  const auto keep = std::span(servo.table).subspan(dynamixel_x::kPresentCurrent, 10);
  std::array<std::uint8_t, 10> measured{};
  std::copy(keep.begin(), keep.end(), measured.begin());
  std::fill(servo.table.begin() + dynamixel_x::kTorqueEnable, servo.table.end(), std::uint8_t{0});
  std::copy(measured.begin(), measured.end(), keep.begin());
  servo.table[dynamixel_x::kStatusReturn] = 2;
  servo.registered.clear();
}

void DynamixelServos::restart() {
  decoder_.clear();
  answers_.clear();
  line_free_ = now_;
  for (Servo& servo : servos_) {
    boot(servo);
    servo.away_until = now_ + kDynamixelBoot;
  }
}

void DynamixelServos::receive(std::span<const std::uint8_t> bytes) {
  if (echo_) {
    const auto later = std::find_if(answers_.begin(), answers_.end(),
                                    [this](const Answer& answer) { return answer.time > now_; });
    answers_.insert(later, {now_, {bytes.begin(), bytes.end()}});
  }
  decoder_.put(bytes);
  while (const auto packet = decoder_.next_instruction()) obey(*packet);
}

void DynamixelServos::advance(double now, std::vector<std::uint8_t>& sent) {
  const double passed = now - now_;
  now_ = now;
  for (Servo& servo : servos_) {
    const double goal =
        dynamixel_signed(std::span(servo.table).subspan(dynamixel_x::kGoalPosition, 4));
    const double way = servo.speed > 0.0 ? servo.speed * passed : std::abs(goal - servo.ramp);
    if (servo.table[dynamixel_x::kTorqueEnable] == 1) {
      servo.ramp = std::clamp(goal, servo.ramp - way, servo.ramp + way);
    }
  }
  while (!answers_.empty() && answers_.front().time <= now_) {
    const auto& bytes = answers_.front().bytes;
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    answers_.pop_front();
  }
}

std::optional<double> DynamixelServos::driven_position(std::size_t servo) const {
  const Servo& it = servos_.at(servo);
  if (it.table[dynamixel_x::kTorqueEnable] == 0) return std::nullopt;
  return it.ramp;
}

void DynamixelServos::set_measured(std::size_t servo, double position, double current) {
  const double unit = servos_.at(servo).made.current_unit;
  const auto count = static_cast<std::int16_t>(std::lround(current / unit));
  store(servo, dynamixel_x::kPresentCurrent, 2, static_cast<std::uint16_t>(count));
  const auto steps = static_cast<std::int32_t>(std::lround(position));
  store(servo, dynamixel_x::kPresentPosition, 4, static_cast<std::uint32_t>(steps));
}

void DynamixelServos::heat(std::size_t servo, std::uint8_t temperature) {
  store(servo, dynamixel_x::kPresentTemperature, 1, temperature);
}

void DynamixelServos::overload(std::size_t servo) {
  Servo& it = servos_.at(servo);
  it.table[dynamixel_x::kHardwareError] |= dynamixel_x::kOverload;
  if ((it.table[dynamixel_x::kShutdown] & dynamixel_x::kOverload) != 0)
    it.table[dynamixel_x::kTorqueEnable] = 0;
}

void DynamixelServos::set_silent(std::size_t servo, bool silent) {
  servos_.at(servo).silent = silent;
}

std::uint32_t DynamixelServos::stored(std::size_t servo, std::uint16_t address,
                                      std::size_t size) const {
  return dynamixel_number(std::span(servos_.at(servo).table).subspan(address, size));
}

void DynamixelServos::store(std::size_t servo, std::uint16_t address, std::size_t size,
                            std::uint32_t value) {
  put_dynamixel_number(std::span(servos_.at(servo).table).subspan(address, size), value);
}

bool DynamixelServos::listens(const Servo& servo) const {
  return !servo.silent && now_ >= servo.away_until;
}

void DynamixelServos::obey(const wire::DynamixelPacket& packet) {
  if (packet.instruction == wire::DynamixelInstruction::kSyncRead)
    return obey_sync_read(packet.parameters);
  if (packet.instruction == wire::DynamixelInstruction::kSyncWrite)
    return obey_sync_write(packet.parameters);
  for (Servo& servo : servos_) {
    const bool addressed =
        packet.id == wire::kDynamixelEveryone || packet.id == servo.table[dynamixel_x::kId];
    if (addressed && listens(servo)) obey_single(servo, packet);
  }
}

void DynamixelServos::obey_single(Servo& servo, const wire::DynamixelPacket& packet) {
  const Span given = packet.parameters;
  std::uint8_t result = 0;
  Span read;
  const auto address =
      static_cast<std::uint16_t>(given.size() < 2 ? 0 : dynamixel_number(given.first(2)));
  if (packet.instruction == wire::DynamixelInstruction::kPing) {
    read = Span(servo.table).first(2);
    const std::array<std::uint8_t, 3> known{read[0], read[1], servo.table[dynamixel_x::kFirmware]};
    return answer(servo, 0, known, 0);
  }
  if (packet.instruction == wire::DynamixelInstruction::kRead && given.size() == 4) {
    const std::size_t size = dynamixel_number(given.subspan(2));
    const bool exists = address + size <= kDynamixelEnd;
    result = exists ? 0 : dynamixel_error::kAccess;
    if (exists) read = Span(servo.table).subspan(address, size);
  } else if (packet.instruction == wire::DynamixelInstruction::kWrite && given.size() > 2) {
    result = write(servo, address, given.subspan(2));
  } else if (packet.instruction == wire::DynamixelInstruction::kRegWrite && given.size() > 2) {
    result = refusal(servo, address, given.subspan(2));
    if (result == 0) servo.registered.assign(given.begin(), given.end());
  } else if (packet.instruction == wire::DynamixelInstruction::kAction &&
             !servo.registered.empty()) {
    const auto registered = std::exchange(servo.registered, {});
    const auto at = static_cast<std::uint16_t>(dynamixel_number(Span(registered).first(2)));
    result = write(servo, at, Span(registered).subspan(2));
  } else if (packet.instruction != wire::DynamixelInstruction::kReboot) {
    result = dynamixel_error::kInstruction;
  }
  const std::uint8_t level = answering_level(packet.instruction);
  if (packet.id != wire::kDynamixelEveryone) answer(servo, result, read, level);
  if (packet.instruction != wire::DynamixelInstruction::kReboot) return;
  boot(servo);
  servo.away_until = now_ + kDynamixelBoot;
}

// The servos answer in the order of the request.
void DynamixelServos::obey_sync_read(Span parameters) {
  if (parameters.size() < 4) return;
  const auto address = static_cast<std::uint16_t>(dynamixel_number(parameters.first(2)));
  const std::size_t size = dynamixel_number(parameters.subspan(2, 2));
  for (const std::uint8_t id : parameters.subspan(4)) {
    for (const Servo& servo : servos_) {
      if (servo.table[dynamixel_x::kId] != id || !listens(servo)) continue;
      const bool exists = address + size <= kDynamixelEnd;
      const Span read = exists ? Span(servo.table).subspan(address, size) : Span();
      answer(servo, exists ? 0 : dynamixel_error::kAccess, read, 1);
    }
  }
}

void DynamixelServos::obey_sync_write(Span parameters) {
  if (parameters.size() < 4) return;
  const auto address = static_cast<std::uint16_t>(dynamixel_number(parameters.first(2)));
  const std::size_t size = dynamixel_number(parameters.subspan(2, 2));
  parameters = parameters.subspan(4);
  for (; parameters.size() > size; parameters = parameters.subspan(size + 1)) {
    for (Servo& servo : servos_) {
      if (servo.table[dynamixel_x::kId] != parameters[0] || !listens(servo)) continue;
      write(servo, address, parameters.subspan(1, size));
    }
  }
}

std::uint8_t DynamixelServos::refusal(const Servo& servo, std::uint16_t address, Span data) const {
  const std::size_t size = data.size();
  const bool powered = servo.table[dynamixel_x::kTorqueEnable] == 1;
  if (address + size > kDynamixelEnd || touches(address, size, 0, 6) ||
      touches(address, size, 69, 70) || touches(address, size, 120, 167) ||
      (powered && address < dynamixel_x::kTorqueEnable)) {
    return dynamixel_error::kAccess;
  }
  if (const auto torque = written_to(dynamixel_x::kTorqueEnable, 1, address, data)) {
    if (*torque > 1) return dynamixel_error::kRange;
    if (*torque == 1 && servo.table[dynamixel_x::kHardwareError] != 0)
      return dynamixel_error::kResult;
  }
  const auto goal = written_to(dynamixel_x::kGoalPosition, 4, address, data);
  const bool one_turn = servo.table[dynamixel_x::kOperatingMode] == 3;
  const auto limits = std::span(servo.table).subspan(dynamixel_x::kMaxPosition, 8);
  const auto steps = static_cast<std::int32_t>(goal.value_or(0));
  const bool beyond =
      steps > dynamixel_signed(limits.first(4)) || steps < dynamixel_signed(limits.subspan(4));
  return goal && one_turn && beyond ? dynamixel_error::kLimit : 0;
}

std::uint8_t DynamixelServos::write(Servo& servo, std::uint16_t address, Span data) {
  if (const std::uint8_t result = refusal(servo, address, data); result != 0) return result;
  if (address < dynamixel_x::kTorqueEnable) ++eeprom_writes_;
  const bool powered = servo.table[dynamixel_x::kTorqueEnable] == 1;
  std::copy(data.begin(), data.end(), servo.table.begin() + address);
  const bool switched_on = !powered && servo.table[dynamixel_x::kTorqueEnable] == 1;
  if (switched_on) {
    servo.ramp = dynamixel_signed(std::span(servo.table).subspan(dynamixel_x::kPresentPosition, 4));
  }
  if (switched_on || touches(address, data.size(), dynamixel_x::kGoalPosition, 119))
    follow_goal(servo);
  return 0;
}

// The profile without acceleration: rectangular, or a step.
void DynamixelServos::follow_goal(Servo& servo) const {
  const auto bytes = std::span(servo.table);
  const double setting = dynamixel_number(bytes.subspan(dynamixel_x::kVelocity, 4));
  const double way =
      std::abs(dynamixel_signed(bytes.subspan(dynamixel_x::kGoalPosition, 4)) - servo.ramp);
  const bool timed = (servo.table[dynamixel_x::kDriveMode] & dynamixel_x::kTimeBasedProfile) != 0;
  servo.speed =
      timed && setting > 0.0 ? way / (setting * 0.001) : setting * dynamixel_x::kVelocityUnit;
}

void DynamixelServos::answer(const Servo& servo, std::uint8_t error_number, Span parameters,
                             std::uint8_t level) {
  if (servo.table[dynamixel_x::kStatusReturn] < level) return;
  const bool alert = servo.table[dynamixel_x::kHardwareError] != 0;
  std::array<std::uint8_t, wire::DynamixelDecoder::kLongest> memory{};
  wire::DynamixelWriter writer(memory);
  writer.status(servo.table[dynamixel_x::kId],
                static_cast<std::uint8_t>(error_number | (alert ? dynamixel_error::kAlert : 0)),
                parameters);
  const double delay = servo.table[dynamixel_x::kReturnDelay] * 2e-6;
  line_free_ = std::max(line_free_, now_) + delay;
  answers_.push_back({line_free_, {writer.written().begin(), writer.written().end()}});
}

}  // namespace somato::emulation
