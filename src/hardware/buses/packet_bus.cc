#include "hardware/buses/packet_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

constexpr std::uint8_t kNoServo = 0xFF;

}  // namespace

PacketBus::PacketBus(const PacketServoKind& kind, const std::vector<PacketServo>& servos,
                     Coders coders)
    : ServoBus(servos.size()), coders_(std::move(coders)), kind_(kind) {
  require(!servos.empty(), "a bus has at least one servo");
  servo_of_id_.fill(kNoServo);
  for (const PacketServo& servo : servos) {
    require(servo.id <= kind.highest_id,
            fmt::format("the id of a {} servo is at most {}", kind.maker, kind.highest_id));
    require(servo_of_id_[servo.id] == kNoServo, "two servos have the same id");
    servo_of_id_[servo.id] = static_cast<std::uint8_t>(ids_.size());
    ids_.push_back(servo.id);
    servos_.push_back({.declared = servo});
  }
}

std::string PacketBus::Servo::place() const {
  return fmt::format("servo with id {}", declared.id);
}

// Enough packets for one to be read whole by a servo that still waits for the `longest` packet.
void PacketBus::set_sizes(std::size_t tick, std::size_t longest) {
  tick_.resize(tick);
  const Bytes once = packet([this](auto& to) {
    to.write(wire::kEveryone, kind_.torque, std::array<std::uint8_t, 1>{0});
  });
  for (std::size_t i = 0; i < longest / once.size() + 2; ++i) {
    relax_.insert(relax_.end(), once.begin(), once.end());
  }
}

wire::PacketWriter& PacketBus::tick_writer() {
  coders_.writer->use(tick_);
  return *coders_.writer;
}

Result<PacketBus::Answer> PacketBus::ask(const Servo& servo, Span request, std::size_t size,
                                         wire::Exchange& exchange) const {
  wire::PacketDecoder& decoder = *coders_.answers;
  decoder.clear();
  Answer answer;
  std::uint8_t refusal = 0;
  const auto take = [&](Span bytes) {
    decoder.put(bytes);
    while (const auto found = decoder.next_status()) {
      refusal = found->error & kind_.refusal;
      if (found->id != servo.id() || (refusal == 0 && found->parameters.size() != size)) continue;
      answer = {found->error, {found->parameters.begin(), found->parameters.end()}};
      return true;
    }
    return false;
  };
  SOMATO_TRY(const bool answered, exchange.request(request, kAnswerTime, kAttempts, take));
  if (!answered) {
    return fail(ErrorKind::kSystem, "the servo does not answer", servo.place(),
                "check its power, its cable, its id and the baud rate");
  }
  if (refusal != 0) {
    return fail(ErrorKind::kData, fmt::format("the servo refuses a request (error {})", refusal),
                servo.place(), fmt::format("check that it is a servo of {}", kind_.series));
  }
  return answer;
}

Result<PacketBus::Answer> PacketBus::read(const Servo& servo, std::uint16_t address,
                                          std::size_t size, wire::Exchange& exchange) {
  const Bytes request =
      packet([&](auto& to) { to.read(servo.id(), address, static_cast<std::uint16_t>(size)); });
  return ask(servo, request, size, exchange);
}

Result<void> PacketBus::check_error(const Servo& servo, std::uint8_t bits) const {
  if (bits == 0) return {};
  std::string names;
  for (std::size_t bit = 0; bit < kind_.errors.size(); ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    names += names.empty() ? "" : ", ";
    names += kind_.errors[bit];
  }
  return fail(ErrorKind::kSystem, fmt::format("the servo reports {} ({})", kind_.error, names),
              servo.place(), "remove the cause, then run 'somato device check FILE --reboot'");
}

void PacketBus::warn_of_delay(const Servo& servo, std::uint8_t units) {
  if (units == 0) return;
  warnings_.push_back(
      fmt::format("{}: it waits {} us before each answer; a return delay "
                  "(address {}) of 0 makes the bus faster",
                  servo.place(), 2 * units, kind_.return_delay));
}

// The goal comes before the torque, so that nothing moves.
Result<void> PacketBus::hold(std::size_t index, wire::Exchange& exchange) {
  SOMATO_TRY_VOID(measure(index, exchange));
  Servo& servo = servos_[index];
  servo.goal = reports_[index].position;
  if (servo.goal < servo.lowest || servo.goal > servo.highest) {
    return fail(ErrorKind::kData,
                fmt::format("the servo stands at {}, outside its limits {} to {}", servo.goal,
                            servo.lowest, servo.highest),
                servo.place(), "move it by hand between its limits");
  }
  SOMATO_TRY_VOID(write_goal(index, exchange));
  return write(servo, kind_.torque, {1}, exchange);
}

Result<void> PacketBus::hold_all(wire::Exchange& exchange) {
  for (std::size_t i = 0; i < servos_.size(); ++i) SOMATO_TRY_VOID(hold(i, exchange));
  return {};
}

Result<void> PacketBus::start(wire::Exchange& exchange) {
  warnings_.clear();
  coders_.states->clear();
  for (ServoReport& report : reports_) report.unanswered = 0;
  for (std::size_t i = 0; i < servos_.size(); ++i) SOMATO_TRY_VOID(check(i, exchange));
  auto held = hold_all(exchange);
  if (!held) SOMATO_TRY_VOID(exchange.send(relax_));
  return held;
}

Result<void> PacketBus::reboot(std::size_t servo, wire::Exchange& exchange) {
  SOMATO_TRY_VOID(restart(servos_.at(servo), exchange));
  SOMATO_TRY_VOID(check(servo, exchange));
  return hold(servo, exchange);
}

double PacketBus::speed_to(std::size_t index, double goal, double seconds) {
  Servo& servo = servos_[index];
  return servo.speed.next(goal, servo.goal, reports_[index].position, seconds);
}

void PacketBus::write_goals(wire::PacketWriter& to, std::span<const double> positions,
                            double seconds) {
  to.begin_sync_write(kind_.goals, kind_.goal_size);
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    Servo& servo = servos_[i];
    if (!std::isfinite(positions[i])) continue;
    const double goal = std::round(std::clamp(positions[i], servo.lowest, servo.highest));
    to.put8(servo.id());
    put_goal(to, i, goal, seconds);
    servo.goal = goal;
  }
  to.end();
}

std::span<const std::uint8_t> PacketBus::tick(std::span<const double> positions, double seconds) {
  require(positions.size() == servos_.size(), "there is one position for each servo");
  wire::PacketWriter& to = tick_writer();
  const auto given = [](double position) { return std::isfinite(position); };
  if (std::any_of(positions.begin(), positions.end(), given)) write_goals(to, positions, seconds);
  request_states(to, seconds);
  return to.written();
}

void PacketBus::receive(std::span<const std::uint8_t> bytes, double now) {
  coders_.states->put(bytes);
  while (const auto packet = coders_.states->next_status()) {
    const std::uint8_t servo = servo_of_id_[packet->id];
    if (servo != kNoServo) take(servo, *packet, now);
  }
}

}  // namespace somato::devices
