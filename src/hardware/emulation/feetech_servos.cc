#include "hardware/emulation/feetech_servos.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/core/check.h"

namespace somato::emulation {
namespace {

namespace feetech = wire::feetech;

constexpr double kFeetechBoot = 0.8;          // s until a servo that was switched on answers
constexpr std::size_t kFeetechEnd = 87;       // of the memory
constexpr std::size_t kFeetechMeasured = 15;  // bytes from the present position on

}  // namespace

FeetechServos::FeetechServos(wire::FeetechSeries series, const std::vector<EmulatedFeetech>& servos,
                             bool echo)
    : series_(series), echo_(echo) {
  for (const EmulatedFeetech& made : servos) servos_.emplace_back().made = made;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const EmulatedFeetech& made = servos_[i].made;
    store(i, feetech::kModel, 2, made.model);
    store(i, feetech::kId, 1, made.id);
    store(i, feetech::kReturnDelay, 1, made.return_delay);
    store(i, feetech::kResponseLevel, 1, 1);
    store(i, feetech::kMaxPosition, 2, is_sts() ? 4095 : 1023);
    FeetechServos::set_measured(i, made.position, 0.0);
    servos_[i].kept = servos_[i].memory;
    boot(servos_[i]);
  }
}

// The measurements stay, because the joint does not move; the goal is 0.
void FeetechServos::boot(Servo& servo) const {
  const Memory before = servo.memory;
  servo.memory = {};
  std::copy_n(servo.kept.begin(), feetech::kTorqueEnable, servo.memory.begin());
  std::copy_n(before.begin() + feetech::kPresentPosition, kFeetechMeasured,
              servo.memory.begin() + feetech::kPresentPosition);
  servo.memory[feetech::kStatus] = 0;
  servo.memory[is_sts() ? feetech::kLockSts : feetech::kLockScs] = 1;
  servo.registered.clear();
}

void FeetechServos::restart() {
  decoder_.clear();
  answers_.clear();
  line_free_ = now_;
  for (Servo& servo : servos_) {
    boot(servo);
    servo.away_until = now_ + kFeetechBoot;
  }
}

void FeetechServos::receive(std::span<const std::uint8_t> bytes) {
  if (echo_) {
    const auto later = std::find_if(answers_.begin(), answers_.end(),
                                    [this](const Answer& answer) { return answer.time > now_; });
    answers_.insert(later, {now_, {bytes.begin(), bytes.end()}});
  }
  decoder_.put(bytes);
  while (const auto packet = decoder_.next()) obey(*packet);
}

void FeetechServos::advance(double now, std::vector<std::uint8_t>& sent) {
  const double passed = now - now_;
  now_ = now;
  for (Servo& servo : servos_) {
    if (servo.memory[feetech::kTorqueEnable] != 1) continue;
    double goal = position(servo, feetech::kGoalPosition);
    const double lowest = word(servo, feetech::kMinPosition);
    const double highest = word(servo, feetech::kMaxPosition);
    if (lowest < highest) goal = std::clamp(goal, lowest, highest);
    const double way = servo.speed > 0.0 ? servo.speed * passed : std::abs(goal - servo.ramp);
    servo.ramp = std::clamp(goal, servo.ramp - way, servo.ramp + way);
  }
  while (!answers_.empty() && answers_.front().time <= now_) {
    const auto& bytes = answers_.front().bytes;
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    answers_.pop_front();
  }
}

std::optional<double> FeetechServos::driven_position(std::size_t servo) const {
  const Servo& it = servos_.at(servo);
  if (it.memory[feetech::kTorqueEnable] != 1) return std::nullopt;
  return it.ramp;
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

void FeetechServos::heat(std::size_t servo, std::uint8_t temperature) {
  store(servo, feetech::kPresentTemperature, 1, temperature);
}

void FeetechServos::overload(std::size_t servo) {
  Servo& it = servos_.at(servo);
  it.memory[feetech::kStatus] |= feetech::kOverload;
  it.memory[feetech::kTorqueEnable] = 0;
}

void FeetechServos::set_silent(std::size_t servo, bool silent) {
  servos_.at(servo).silent = silent;
}

std::uint16_t FeetechServos::stored(std::size_t servo, std::uint8_t address,
                                    std::size_t size) const {
  const Servo& it = servos_.at(servo);
  return size == 1 ? it.memory[address] : word(it, address);
}

void FeetechServos::store(std::size_t servo, std::uint8_t address, std::size_t size,
                          std::uint16_t value) {
  Servo& it = servos_.at(servo);
  const auto bytes = wire::feetech_bytes(value, wire::feetech_order(series_));
  it.memory[address] = size == 1 ? static_cast<std::uint8_t>(value) : bytes[0];
  if (size == 2) it.memory[address + std::size_t{1}] = bytes[1];
  if (address < feetech::kTorqueEnable) it.kept = it.memory;
}

std::uint16_t FeetechServos::word(const Servo& servo, std::uint8_t address) const {
  return wire::feetech_word(Span(servo.memory).subspan(address, 2), wire::feetech_order(series_));
}

double FeetechServos::position(const Servo& servo, std::uint8_t address) const {
  return wire::feetech_signed(word(servo, address));
}

bool FeetechServos::listens(const Servo& servo) const {
  return !servo.silent && now_ >= servo.away_until;
}

void FeetechServos::obey(const wire::FeetechPacket& packet) {
  const auto instruction = static_cast<wire::FeetechInstruction>(packet.code);
  const bool everyone = packet.id == wire::kFeetechEveryone;
  if (everyone && instruction == wire::FeetechInstruction::kSyncRead) {
    return obey_sync_read(packet.parameters);
  }
  if (everyone && instruction == wire::FeetechInstruction::kSyncWrite) {
    return obey_sync_write(packet.parameters);
  }
  for (Servo& servo : servos_) {
    const bool addressed = everyone || packet.id == servo.memory[feetech::kId];
    if (addressed && listens(servo)) obey_single(servo, packet);
  }
}

void FeetechServos::obey_single(Servo& servo, const wire::FeetechPacket& packet) {
  const Span given = packet.parameters;
  const bool everyone = packet.id == wire::kFeetechEveryone;
  switch (static_cast<wire::FeetechInstruction>(packet.code)) {
    case wire::FeetechInstruction::kPing:
      return answer(servo, {});
    case wire::FeetechInstruction::kRead:
      if (everyone || given.size() != 2 || given[0] + std::size_t{given[1]} > kFeetechEnd) return;
      return answer(servo, Span(servo.memory).subspan(given[0], given[1]));
    case wire::FeetechInstruction::kWrite:
      write(servo, given);
      break;
    case wire::FeetechInstruction::kRegWrite:
      servo.registered.assign(given.begin(), given.end());
      break;
    case wire::FeetechInstruction::kAction:
      write(servo, std::exchange(servo.registered, {}));
      break;
    case wire::FeetechInstruction::kReboot:
      boot(servo);
      servo.away_until = now_ + kFeetechBoot;
      return;
    default:
      return;
  }
  if (!everyone && servo.memory[feetech::kResponseLevel] == 1) answer(servo, {});
}

// The servos answer in the order of the request; those of the SCS series do not know it.
void FeetechServos::obey_sync_read(Span parameters) {
  if (!is_sts() || parameters.size() < 2) return;
  const std::size_t address = parameters[0];
  const std::size_t size = parameters[1];
  if (address + size > kFeetechEnd) return;
  for (const std::uint8_t id : parameters.subspan(2)) {
    for (const Servo& servo : servos_) {
      if (servo.memory[feetech::kId] != id || !listens(servo)) continue;
      answer(servo, Span(servo.memory).subspan(address, size));
    }
  }
}

void FeetechServos::obey_sync_write(Span parameters) {
  if (parameters.size() < 2) return;
  std::vector<std::uint8_t> data{parameters[0]};  // the address and the data of one servo
  const std::size_t size = parameters[1];
  parameters = parameters.subspan(2);
  for (; parameters.size() > size; parameters = parameters.subspan(size + 1)) {
    data.resize(1);
    data.insert(data.end(), parameters.begin() + 1,
                parameters.begin() + 1 + static_cast<std::ptrdiff_t>(size));
    for (Servo& servo : servos_) {
      if (servo.memory[feetech::kId] == parameters[0] && listens(servo)) write(servo, data);
    }
  }
}

void FeetechServos::write(Servo& servo, Span address_and_data) {
  if (address_and_data.size() < 2) return;
  const std::size_t address = address_and_data[0];
  const Span data = address_and_data.subspan(1);
  if (address < feetech::kTorqueEnable) ++eeprom_writes_;
  const bool powered = servo.memory[feetech::kTorqueEnable] == 1;
  for (std::size_t i = 0; i < data.size(); ++i) write_byte(servo, address + i, data[i]);
  const bool switched_on = !powered && servo.memory[feetech::kTorqueEnable] == 1;
  if (switched_on) servo.ramp = position(servo, feetech::kPresentPosition);
  const bool goal = address <= feetech::kGoalPosition + std::size_t{1} &&
                    address + data.size() > feetech::kGoalPosition;
  if (switched_on || goal) follow_goal(servo);
}

void FeetechServos::write_byte(Servo& servo, std::size_t address, std::uint8_t value) const {
  const bool fixed = address < feetech::kId || address >= feetech::kPresentPosition;
  const bool failed = address == feetech::kTorqueEnable && servo.memory[feetech::kStatus] != 0;
  if (fixed || (failed && value != 0)) return;
  servo.memory[address] = value;
  const bool locked = servo.memory[is_sts() ? feetech::kLockSts : feetech::kLockScs] != 0;
  if (address < feetech::kTorqueEnable && !locked) servo.kept[address] = value;
}

// STS servos move with a speed; SCS servos also within a time.
void FeetechServos::follow_goal(Servo& servo) const {
  const double way = std::abs(position(servo, feetech::kGoalPosition) - servo.ramp);
  const double milliseconds = is_sts() ? 0.0 : word(servo, feetech::kGoalTime);
  servo.speed =
      milliseconds > 0.0 ? way / (milliseconds * 0.001) : word(servo, feetech::kGoalSpeed);
}

void FeetechServos::answer(const Servo& servo, Span data) {
  std::array<std::uint8_t, wire::FeetechDecoder::kLongest> memory{};
  wire::FeetechWriter writer(memory, wire::feetech_order(series_));
  writer.status(servo.memory[feetech::kId], servo.memory[feetech::kStatus], data);
  line_free_ = std::max(line_free_, now_) + servo.memory[feetech::kReturnDelay] * 2e-6;
  answers_.push_back({line_free_, {writer.written().begin(), writer.written().end()}});
}

}  // namespace somato::emulation
