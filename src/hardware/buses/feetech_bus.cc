#include "hardware/buses/feetech_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

namespace feetech = wire::feetech;
using wire::FeetechSeries;

constexpr std::array kFeetechModels = std::to_array<FeetechModel>({
    {"STS", 0, FeetechSeries::kSts},
    {"SCS", 0, FeetechSeries::kScs},
    {"STS3215", 777, FeetechSeries::kSts},
    {"STS3250", 2825, FeetechSeries::kSts},
    {"SM8512BL", 11272, FeetechSeries::kSts},
    {"SCS0009", 1284, FeetechSeries::kScs},
});

constexpr std::uint8_t kNoFeetech = 0xFF;
constexpr std::size_t kFeetechGoalSize = 6;  // position, time and speed
constexpr std::size_t kFeetechStsStateSize =
    15;                                          // from the present position to the present current
constexpr std::size_t kFeetechScsStateSize = 8;  // position, speed, load, voltage and temperature
constexpr std::size_t kFeetechStsSettings = 34;  // from the firmware to the mode
constexpr std::size_t kFeetechScsSettings = 13;  // from the firmware to the limits
constexpr std::size_t kFeetechLongestAnswer = 6 + kFeetechStsSettings;
constexpr double kFeetechSpeedUnit = 50.0;   // steps/s
constexpr double kFeetechAnswerWait = 0.05;  // s; an adapter may collect bytes for 16 ms
constexpr std::size_t kFeetechTries = 3;

const FeetechModel* find_feetech_model(std::string_view name) {
  const auto* found = std::find_if(kFeetechModels.begin(), kFeetechModels.end(),
                                   [&](const auto& model) { return model.name == name; });
  return found == kFeetechModels.end() ? nullptr : found;
}

std::string feetech_place(const FeetechServo& servo) {
  return fmt::format("servo with id {}", servo.id);
}

std::string feetech_error_names(std::uint8_t bits) {
  constexpr std::array<std::string_view, 6> kNames{"voltage", "position sensor", "overheating",
                                                   "current", "bit 4",           "overload"};
  std::string text;
  for (std::size_t bit = 0; bit < kNames.size(); ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    text += text.empty() ? "" : ", ";
    text += kNames[bit];
  }
  return text;
}

}  // namespace

std::span<const FeetechModel> feetech_models() {
  return kFeetechModels;
}

FeetechBus::FeetechBus(std::vector<FeetechServo> servos)
    : ServoBus(servos.size()), decoder_(6 + kFeetechStsStateSize) {
  require(!servos.empty(), "a bus has at least one servo");
  servo_of_id_.fill(kNoFeetech);
  for (FeetechServo& servo : servos) {
    const FeetechModel* model = find_feetech_model(servo.model);
    require(model, fmt::format("'{}' is not a Feetech model that is known", servo.model));
    if (servos_.empty()) series_ = model->series;
    require(series_ == model->series, "the servos of a bus are of one series");
    require(servo.id <= 253, "the id of a Feetech servo is at most 253");
    require(servo_of_id_[servo.id] == kNoFeetech, "two servos have the same id");
    servo_of_id_[servo.id] = static_cast<std::uint8_t>(ids_.size());
    ids_.push_back(servo.id);
    servos_.push_back({.declared = std::move(servo), .model = model});
  }
  require(ids_.size() <= 35, "a packet has at most the goals of 35 servos");
  const std::size_t goals = 8 + ids_.size() * (1 + kFeetechGoalSize);
  tick_.resize(goals + 8 + (is_sts() ? ids_.size() : 0));
  const auto relax = packet([](auto& to) {
    to.write(wire::kFeetechEveryone, feetech::kTorqueEnable, std::array<std::uint8_t, 1>{0});
  });
  // Enough for one to be read whole by a servo that waits for the rest of the longest packet of the
  // protocol: if the packet before was cut off ahead of its length, the length is read as 255.
  for (std::size_t i = 0; i < wire::FeetechDecoder::kLongest / relax.size() + 2; ++i) {
    relax_.insert(relax_.end(), relax.begin(), relax.end());
  }
}

std::size_t FeetechBus::state_size() const {
  return is_sts() ? kFeetechStsStateSize : kFeetechScsStateSize;
}

std::size_t FeetechBus::bytes_per_tick() const {
  const std::size_t requests = is_sts() ? 0 : 8 * (ids_.size() - 1);
  return tick_.size() + requests + ids_.size() * (6 + state_size());
}

// The answer that was lost, and the one after it.
double FeetechBus::recovery() const {
  return is_sts() ? 0.0 : 2.0 * kFeetechAnswerWait;
}

std::uint16_t FeetechBus::word(std::span<const std::uint8_t> bytes, std::size_t at) const {
  return wire::feetech_word(bytes.subspan(at, 2), wire::feetech_order(series_));
}

template <typename Fill>
FeetechBus::Bytes FeetechBus::packet(const Fill& fill) const {
  std::array<std::uint8_t, 64> memory{};
  wire::FeetechWriter writer(memory, wire::feetech_order(series_));
  fill(writer);
  return {writer.written().begin(), writer.written().end()};
}

// A read also replaces the ping, whose echo looks like its answer with an error. Answers differ
// from echoes by their size, as long as no two bytes are read.
Result<FeetechBus::Answer> FeetechBus::read(const Servo& servo, std::uint8_t address,
                                            std::size_t size, wire::Exchange& exchange) const {
  const auto request = packet(
      [&](auto& to) { to.read(servo.declared.id, address, static_cast<std::uint8_t>(size)); });
  wire::FeetechDecoder decoder(kFeetechLongestAnswer);
  Answer answer;
  const auto take = [&](std::span<const std::uint8_t> bytes) {
    decoder.put(bytes);
    while (const auto found = decoder.next()) {
      if (found->id != servo.declared.id || found->parameters.size() != size) continue;
      answer = {found->code, {found->parameters.begin(), found->parameters.end()}};
      return true;
    }
    return false;
  };
  SOMATO_TRY(const bool answered,
             exchange.request(request, kFeetechAnswerWait, kFeetechTries, take));
  if (answered) return answer;
  return fail(ErrorKind::kSystem, "the servo does not answer", feetech_place(servo.declared),
              "check its power, its cable, its id and the baud rate");
}

// Servos may be set not to answer writes, therefore what was written is read again.
Result<void> FeetechBus::write(const Servo& servo, std::uint8_t address, const Bytes& data,
                               wire::Exchange& exchange) const {
  for (std::size_t i = 0; i < kFeetechTries; ++i) {
    SOMATO_TRY_VOID(
        exchange.send(packet([&](auto& to) { to.write(servo.declared.id, address, data); })));
    SOMATO_TRY(const auto answer, read(servo, address, data.size(), exchange));
    if (answer.data == data) return {};
  }
  return fail(ErrorKind::kSystem, fmt::format("the servo does not accept address {}", address),
              feetech_place(servo.declared), "switch it off and on");
}

Result<void> FeetechBus::check(Servo& servo, wire::Exchange& exchange) {
  const std::size_t size = is_sts() ? kFeetechStsSettings : kFeetechScsSettings;
  SOMATO_TRY(const auto answer, read(servo, 0, size, exchange));
  const unsigned number = word(answer.data, feetech::kModel);
  if (servo.model->number != 0 && servo.model->number != number) {
    return fail(ErrorKind::kData,
                fmt::format("the servo has the model number {}, not {} as a {}", number,
                            servo.model->number, servo.model->name),
                feetech_place(servo.declared), "correct the model or the id in the device file");
  }
  if (answer.data[feetech::kReturnDelay] != 0) {
    warnings_.push_back(
        fmt::format("{}: it waits {} us before each answer; a return delay "
                    "(address 7) of 0 makes the bus faster",
                    feetech_place(servo.declared), 2 * answer.data[feetech::kReturnDelay]));
  }
  if (is_sts() && answer.data[feetech::kMode] != 0) {
    return fail(
        ErrorKind::kData,
        fmt::format("the servo does not hold positions (mode {})", answer.data[feetech::kMode]),
        feetech_place(servo.declared), "set its mode (address 33) to 0 with the maker's program");
  }
  return check_limits(servo, answer.data);
}

// Limits of 0 stand for many turns (STS), or for a motor without positions (SCS).
Result<void> FeetechBus::check_limits(Servo& servo, std::span<const std::uint8_t> memory) const {
  servo.lowest = word(memory, feetech::kMinPosition);
  servo.highest = word(memory, feetech::kMaxPosition);
  if (is_sts() && servo.lowest == 0.0 && servo.highest == 0.0) {
    servo.lowest = -32767.0;
    servo.highest = 32767.0;
  }
  if (servo.lowest < servo.highest) return {};
  return fail(
      ErrorKind::kData,
      fmt::format("the servo has no range: its limits are {} and {}", servo.lowest, servo.highest),
      feetech_place(servo.declared), "correct its limits (addresses 9 and 11)");
}

// The goal comes before the torque, so that nothing moves.
Result<void> FeetechBus::hold(std::size_t index, wire::Exchange& exchange) {
  Servo& servo = servos_[index];
  SOMATO_TRY(const auto state, read(servo, feetech::kPresentPosition, state_size(), exchange));
  take_state(index, {servo.declared.id, state.error, state.data}, exchange.now());
  if (state.error != 0) {
    return fail(ErrorKind::kSystem,
                fmt::format("the servo reports an error ({})", feetech_error_names(state.error)),
                feetech_place(servo.declared),
                "remove the cause, then run 'somato device check FILE --reboot'");
  }
  servo.goal = reports_[index].position;
  if (servo.goal < servo.lowest || servo.goal > servo.highest) {
    return fail(ErrorKind::kData,
                fmt::format("the servo stands at {}, outside its limits {} to {}", servo.goal,
                            servo.lowest, servo.highest),
                feetech_place(servo.declared), "move it by hand between its limits");
  }
  Bytes memory(kFeetechGoalSize);
  wire::FeetechWriter goal(memory, wire::feetech_order(series_));
  put_goal(goal, index, servo.goal, 1.0);
  SOMATO_TRY_VOID(write(servo, feetech::kGoalPosition, memory, exchange));
  if (is_sts()) SOMATO_TRY_VOID(write(servo, feetech::kAcceleration, {0}, exchange));
  return write(servo, feetech::kTorqueEnable, {1}, exchange);
}

Result<void> FeetechBus::hold_all(wire::Exchange& exchange) {
  for (std::size_t i = 0; i < servos_.size(); ++i) SOMATO_TRY_VOID(hold(i, exchange));
  return {};
}

Result<void> FeetechBus::start(wire::Exchange& exchange) {
  warnings_.clear();
  decoder_.clear();
  polled_ = servos_.size() - 1;  // the first tick polls the first servo
  to_poll_ = 0;
  answered_ = true;
  for (ServoReport& report : reports_) report.unanswered = 0;
  for (Servo& servo : servos_) SOMATO_TRY_VOID(check(servo, exchange));
  auto held = hold_all(exchange);
  if (!held) SOMATO_TRY_VOID(exchange.send(relax_));
  return held;
}

// The maker demands that the torque is off before a restart, which takes 0.8 s.
Result<void> FeetechBus::reboot(std::size_t index, wire::Exchange& exchange) {
  constexpr double kPollTime = 0.2;
  constexpr int kPolls = 10;
  Servo& servo = servos_.at(index);
  SOMATO_TRY_VOID(exchange.send(packet([&](auto& to) {
    to.write(servo.declared.id, feetech::kTorqueEnable, std::array<std::uint8_t, 1>{0});
    to.reboot(servo.declared.id);
  })));
  for (int i = 0; i < kPolls; ++i) {
    exchange.pause(kPollTime);
    if (read(servo, feetech::kTorqueEnable, 1, exchange)) break;
  }
  SOMATO_TRY_VOID(check(servo, exchange));
  return hold(index, exchange);
}

void FeetechBus::put_goal(wire::FeetechWriter& to, std::size_t index, double goal, double seconds) {
  Servo& servo = servos_[index];
  const double speed = servo.speed.next(goal, servo.goal, reports_[index].position, seconds);
  const double units = std::clamp(std::ceil(speed / kFeetechSpeedUnit), 1.0, 655.0);
  const double time = std::clamp(std::round(seconds * 1000.0), 1.0, 9999.0);
  to.put16(wire::feetech_unsigned(static_cast<int>(goal)));
  to.put16(static_cast<std::uint16_t>(is_sts() ? 0.0 : time));
  to.put16(static_cast<std::uint16_t>(is_sts() ? units * kFeetechSpeedUnit : 0.0));
}

void FeetechBus::write_goals(wire::FeetechWriter& to, std::span<const double> positions,
                             double seconds) {
  to.begin_sync_write(feetech::kGoalPosition, kFeetechGoalSize);
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    Servo& servo = servos_[i];
    if (!std::isfinite(positions[i])) continue;
    const double goal = std::round(std::clamp(positions[i], servo.lowest, servo.highest));
    to.put8(servo.declared.id);
    put_goal(to, i, goal, seconds);
    servo.goal = goal;
  }
  to.end();
}

std::span<const std::uint8_t> FeetechBus::tick(std::span<const double> positions, double seconds) {
  require(positions.size() == servos_.size(), "there is one position for each servo");
  wire::FeetechWriter to(tick_, wire::feetech_order(series_));
  const auto given = [](double position) { return std::isfinite(position); };
  if (std::any_of(positions.begin(), positions.end(), given)) write_goals(to, positions, seconds);
  to_poll_ = servos_.size();
  waited_ += seconds;
  if (!is_sts()) {
    return answered_ || waited_ >= kFeetechAnswerWait ? poll_one(to) : to.written();
  }
  to.sync_read(feetech::kPresentPosition, static_cast<std::uint8_t>(state_size()), ids_);
  decoder_.expect_echo(to.written());
  return to.written();
}

// Requests the state of the next servo. The remainder of an answer that was cut off must not be
// completed by the next one.
std::span<const std::uint8_t> FeetechBus::poll_one(wire::FeetechWriter& to) {
  polled_ = (polled_ + 1) % servos_.size();
  ++reports_[polled_].unanswered;
  --to_poll_;
  answered_ = false;
  waited_ = 0.0;
  to.read(ids_[polled_], feetech::kPresentPosition, static_cast<std::uint8_t>(state_size()));
  decoder_.clear();
  decoder_.expect_echo(to.written());
  return to.written();
}

std::span<const std::uint8_t> FeetechBus::follow_up() {
  if (is_sts() || !answered_ || to_poll_ == 0) return {};
  wire::FeetechWriter to(tick_, wire::feetech_order(series_));
  return poll_one(to);
}

// The sum protects a packet badly: two flags of STS servos and the range of SCS servos are checked
// as well, because they are wrong in most packets that lack a byte.
bool FeetechBus::is_state(std::size_t servo, const wire::FeetechPacket& packet) const {
  constexpr std::size_t kRegistered = 64 - feetech::kPresentPosition;
  constexpr std::size_t kMoving = 66 - feetech::kPresentPosition;
  if (packet.parameters.size() != state_size()) return false;
  if (is_sts()) return packet.parameters[kRegistered] <= 1 && packet.parameters[kMoving] <= 1;
  return servo == polled_ && word(packet.parameters, 0) <= 1023;
}

void FeetechBus::take_state(std::size_t servo, const wire::FeetechPacket& packet, double now) {
  ServoReport& report = reports_[servo];
  report.position = wire::feetech_signed(word(packet.parameters, 0));
  report.temperature = packet.parameters[feetech::kPresentTemperature - feetech::kPresentPosition];
  report.error = packet.code;
  report.time = now;
  report.unanswered = 0;
  if (!is_sts()) return;
  const std::size_t current = feetech::kPresentCurrent - feetech::kPresentPosition;
  report.current = feetech::kCurrentUnit * wire::feetech_signed(word(packet.parameters, current));
}

void FeetechBus::receive(std::span<const std::uint8_t> bytes, double now) {
  decoder_.put(bytes);
  while (const auto packet = decoder_.next()) {
    const std::uint8_t servo = servo_of_id_[packet->id];
    if (servo == kNoFeetech || !is_state(servo, *packet)) continue;
    take_state(servo, *packet, now);
    answered_ = true;
  }
}

}  // namespace somato::devices
