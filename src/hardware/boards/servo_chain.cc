#include "hardware/boards/servo_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato::emulation {

ServoChain::ServoChain(const ServoMemory& layout, std::size_t servos, bool echo,
                       std::unique_ptr<wire::PacketWriter> writer,
                       std::unique_ptr<wire::PacketDecoder> decoder)
    : servos_(servos),
      layout_(layout),
      echo_(echo),
      writer_(std::move(writer)),
      decoder_(std::move(decoder)) {}

// The measurements stay, because the joint does not move. The goal of a servo that boots is not
// documented: 0 moves it, unless the host writes one first.
void ServoChain::boot(Servo& servo) const {
  const auto before = std::exchange(servo.memory, {});
  std::copy_n(servo.kept.begin(), layout_.torque, servo.memory.begin());
  std::copy_n(before.begin() + layout_.measured, layout_.measured_size,
              servo.memory.begin() + layout_.measured);
  set_defaults(servo);
  servo.registered.clear();
}

void ServoChain::reboot(Servo& servo) const {
  boot(servo);
  servo.away_until = now_ + layout_.boot;
}

void ServoChain::restart() {
  decoder_->clear();
  answers_.clear();
  line_free_ = now_;
  for (Servo& servo : servos_) reboot(servo);
}

void ServoChain::receive(std::span<const std::uint8_t> bytes) {
  if (echo_) {
    const auto later = std::find_if(answers_.begin(), answers_.end(),
                                    [this](const Answer& answer) { return answer.time > now_; });
    answers_.insert(later, {now_, {bytes.begin(), bytes.end()}});
  }
  decoder_->put(bytes);
  while (const auto packet = decoder_->next_instruction()) obey(*packet);
}

void ServoChain::advance(double now, std::vector<std::uint8_t>& sent) {
  const double passed = now - now_;
  now_ = now;
  for (Servo& servo : servos_) {
    if (!is_powered(servo)) continue;
    const double goal = limited_goal(servo);
    const double way = servo.speed > 0.0 ? servo.speed * passed : std::abs(goal - servo.ramp);
    servo.ramp = std::clamp(goal, servo.ramp - way, servo.ramp + way);
  }
  while (!answers_.empty() && answers_.front().time <= now_) {
    const auto& bytes = answers_.front().bytes;
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    answers_.pop_front();
  }
}

std::optional<double> ServoChain::driven_position(std::size_t servo) const {
  const Servo& it = servos_.at(servo);
  return is_powered(it) ? std::optional(it.ramp) : std::nullopt;
}

void ServoChain::heat(std::size_t servo, std::uint8_t temperature) {
  store(servo, layout_.temperature, 1, temperature);
}

std::uint32_t ServoChain::number(Span bytes) const {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool low_first = layout_.order == wire::ByteOrder::kLowFirst;
    value = value << 8 | bytes[low_first ? bytes.size() - 1 - i : i];
  }
  return value;
}

std::uint32_t ServoChain::number(const Servo& servo, std::uint16_t address,
                                 std::size_t size) const {
  return number(Span(servo.memory).subspan(address, size));
}

std::uint32_t ServoChain::stored(std::size_t servo, std::uint16_t address, std::size_t size) const {
  return number(servos_.at(servo), address, size);
}

void ServoChain::store(std::size_t servo, std::uint16_t address, std::size_t size,
                       std::uint32_t value) {
  Servo& it = servos_.at(servo);
  for (std::size_t i = 0; i < size; ++i, value >>= 8) {
    const std::size_t at = layout_.order == wire::ByteOrder::kLowFirst ? i : size - 1 - i;
    it.memory[address + at] = static_cast<std::uint8_t>(value & 0xFF);
  }
  if (address < layout_.torque) it.kept = it.memory;
}

void ServoChain::obey(const wire::Packet& packet) {
  const bool everyone = packet.id == wire::kEveryone;
  const bool may_be_sync = everyone || layout_.sync_by_any_id;
  if (may_be_sync && packet.instruction == Instruction::kSyncRead) {
    return obey_sync_read(packet.parameters);
  }
  if (may_be_sync && packet.instruction == Instruction::kSyncWrite) {
    return obey_sync_write(packet.parameters);
  }
  for (Servo& servo : servos_) {
    const bool addressed = everyone || packet.id == servo.memory[layout_.id];
    if (addressed && listens(servo)) obey_single(servo, packet);
  }
}

// The servos answer in the order of the request.
void ServoChain::obey_sync_read(Span parameters) {
  const std::size_t fixed = 2 * layout_.address_size;
  if (parameters.size() < fixed) return;
  for (const std::uint8_t id : parameters.subspan(fixed)) {
    for (const Servo& servo : servos_) {
      if (servo.memory[layout_.id] != id || !listens(servo)) continue;
      answer_read(servo, Instruction::kSyncRead, parameters.first(fixed));
    }
  }
}

void ServoChain::obey_sync_write(Span parameters) {
  const std::size_t fixed = layout_.address_size;
  if (parameters.size() < 2 * fixed) return;
  const Span address = parameters.first(fixed);
  std::vector<std::uint8_t> data(address.begin(), address.end());  // and those of one servo
  const std::size_t size = number(parameters.subspan(fixed, fixed));
  parameters = parameters.subspan(2 * fixed);
  for (; parameters.size() > size; parameters = parameters.subspan(size + 1)) {
    const Span values = parameters.subspan(1, size);
    data.resize(fixed);
    data.insert(data.end(), values.begin(), values.end());
    for (Servo& servo : servos_) {
      if (servo.memory[layout_.id] == parameters[0] && listens(servo)) write(servo, data);
    }
  }
}

std::uint8_t ServoChain::write(Servo& servo, Span address_and_data) {
  if (address_and_data.size() <= layout_.address_size) return 0;
  const std::size_t address = number(address_and_data.first(layout_.address_size));
  const Span data = address_and_data.subspan(layout_.address_size);
  if (const std::uint8_t result = refusal(servo, address, data); result != 0) return result;
  if (address < layout_.torque) ++eeprom_writes_;
  const bool powered = is_powered(servo);
  for (std::size_t i = 0; i < data.size(); ++i) write_byte(servo, address + i, data[i]);
  const bool switched_on = !powered && is_powered(servo);
  if (switched_on) servo.ramp = position(servo, layout_.position);
  const bool goal =
      address < layout_.goal + layout_.goal_size && address + data.size() > layout_.goal;
  if (!switched_on && !goal) return 0;
  servo.speed = speed(servo, std::abs(position(servo, layout_.goal) - servo.ramp));
  return 0;
}

void ServoChain::answer_read(const Servo& servo, Instruction to, Span address_and_size) {
  const std::size_t address = number(address_and_size.first(layout_.address_size));
  const std::size_t size = number(address_and_size.subspan(layout_.address_size));
  if (address + size <= layout_.end) {
    answer(servo, to, 0, Span(servo.memory).subspan(address, size));
  } else if (layout_.access_error != 0) {
    answer(servo, to, layout_.access_error, {});
  }
}

void ServoChain::answer(const Servo& servo, Instruction to, std::uint8_t error, Span data) {
  if (!answers(servo, to)) return;
  std::array<std::uint8_t, 1024> memory{};
  writer_->use(memory);
  writer_->status(servo.memory[layout_.id], error | error_bits(servo), data);
  line_free_ = std::max(line_free_, now_) + servo.memory[layout_.return_delay] * 2e-6;
  answers_.push_back({line_free_, {writer_->written().begin(), writer_->written().end()}});
}

}  // namespace somato::emulation
