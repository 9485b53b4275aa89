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

constexpr std::size_t kFeetechStsStateSize =
    15;                                          // from the present position to the present current
constexpr std::size_t kFeetechScsStateSize = 8;  // position, speed, load, voltage and temperature
constexpr std::size_t kFeetechStsSettings = 34;  // from the firmware to the mode
constexpr std::size_t kFeetechScsSettings = 13;  // from the firmware to the limits
constexpr std::size_t kFeetechLongestAnswer = 6 + kFeetechStsSettings;
constexpr std::uint16_t kFeetechIdentity = feetech::kModel + 2;  // bytes as far as the model
constexpr double kFeetechSpeedUnit = 50.0;                       // steps/s

constexpr PacketServoKind kFeetechServos{
    .maker = "Feetech",
    .series = "the STS or SCS series",
    .highest_id = 253,
    .torque = feetech::kTorqueEnable,
    .return_delay = feetech::kReturnDelay,
    .goals = feetech::kGoalPosition,
    .goal_size = 6,  // position, time and speed
    .error = "an error",
    .errors = {"voltage", "position sensor", "overheating", "current", "bit 4", "overload"},
};

const FeetechModel* feetech_model_of(const PacketServo& servo) {
  const auto* found = std::find_if(kFeetechModels.begin(), kFeetechModels.end(),
                                   [&](const auto& model) { return model.name == servo.model; });
  require(found != kFeetechModels.end(),
          fmt::format("'{}' is not a Feetech model that is known", servo.model));
  return found;
}

FeetechSeries feetech_series_of(const std::vector<PacketServo>& servos) {
  return servos.empty() ? FeetechSeries::kSts : feetech_model_of(servos.front())->series;
}

}  // namespace

std::span<const FeetechModel> feetech_models() {
  return kFeetechModels;
}

BusInquiry feetech_inquiry(wire::FeetechSeries series) {
  BusInquiry inquiry;
  inquiry.order = wire::feetech_order(series);
  inquiry.writer = std::make_unique<wire::FeetechWriter>(inquiry.order);
  inquiry.decoder = std::make_unique<wire::FeetechDecoder>();
  inquiry.request = [](wire::PacketWriter& to, std::uint8_t id) {
    to.read(id, 0, kFeetechIdentity);
  };
  inquiry.size = kFeetechIdentity;
  inquiry.model = feetech::kModel;
  inquiry.ids = kFeetechServos.highest_id + 1;
  inquiry.name_of = [](unsigned model) { return name_of_model(kFeetechModels, model); };
  return inquiry;
}

FeetechBus::FeetechBus(const std::vector<PacketServo>& servos)
    : PacketBus(
          kFeetechServos, servos,
          {std::make_unique<wire::FeetechWriter>(wire::feetech_order(feetech_series_of(servos))),
           std::make_unique<wire::FeetechDecoder>(6 + kFeetechStsStateSize),
           std::make_unique<wire::FeetechDecoder>(kFeetechLongestAnswer)}),
      series_(feetech_series_of(servos)) {
  for (const PacketServo& servo : servos) {
    models_.push_back(feetech_model_of(servo));
    require(series_ == models_.back()->series, "the servos of a bus are of one series");
  }
  require(ids_.size() <= 35, "a packet has at most the goals of 35 servos");
  const std::size_t goals = 8 + ids_.size() * (1 + kFeetechServos.goal_size);
  // If a packet was cut off ahead of its length, the length is read as 255.
  set_sizes(goals + 8 + (is_sts() ? ids_.size() : 0), wire::FeetechDecoder::kLongest);
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
  return is_sts() ? 0.0 : 2.0 * kAnswerTime;
}

std::uint16_t FeetechBus::word(Span bytes, std::size_t at) const {
  return wire::feetech_word(bytes.subspan(at, 2), wire::feetech_order(series_));
}

// Servos may be set not to answer writes, therefore what was written is read again.
Result<void> FeetechBus::write(const Servo& servo, std::uint16_t address, const Bytes& data,
                               wire::Exchange& exchange) {
  for (std::size_t i = 0; i < kAttempts; ++i) {
    SOMATO_TRY_VOID(exchange.send(packet([&](auto& to) { to.write(servo.id(), address, data); })));
    SOMATO_TRY(const auto answer, read(servo, address, data.size(), exchange));
    if (answer.data == data) return {};
  }
  return fail(ErrorKind::kSystem, fmt::format("the servo does not accept address {}", address),
              servo.place(), "switch it off and on");
}

// A read also replaces the ping, whose echo looks like its answer with an error. Answers differ
// from echoes by their size, as long as no two bytes are read.
Result<void> FeetechBus::check(std::size_t index, wire::Exchange& exchange) {
  Servo& servo = servos_[index];
  const FeetechModel& model = *models_[index];
  const std::size_t size = is_sts() ? kFeetechStsSettings : kFeetechScsSettings;
  SOMATO_TRY(const auto answer, read(servo, 0, size, exchange));
  const unsigned number = word(answer.data, feetech::kModel);
  if (model.number != 0 && model.number != number) {
    return fail(ErrorKind::kData,
                fmt::format("the servo has the model number {}, not {} as a {}", number,
                            model.number, model.name),
                servo.place(), "correct the model or the id in the device file");
  }
  warn_of_delay(servo, answer.data[feetech::kReturnDelay]);
  if (is_sts() && answer.data[feetech::kMode] != 0) {
    return fail(
        ErrorKind::kData,
        fmt::format("the servo does not hold positions (mode {})", answer.data[feetech::kMode]),
        servo.place(), "set its mode (address 33) to 0 with the maker's program");
  }
  return check_limits(servo, answer.data);
}

// Limits of 0 stand for many turns (STS), or for a motor without positions (SCS).
Result<void> FeetechBus::check_limits(Servo& servo, Span memory) const {
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
      servo.place(), "correct its limits (addresses 9 and 11)");
}

Result<void> FeetechBus::measure(std::size_t index, wire::Exchange& exchange) {
  SOMATO_TRY(const auto state,
             read(servos_[index], feetech::kPresentPosition, state_size(), exchange));
  take_state(index, state.error, state.data, exchange.now());
  return check_error(servos_[index], state.error);
}

Result<void> FeetechBus::write_goal(std::size_t index, wire::Exchange& exchange) {
  const Servo& servo = servos_[index];
  Bytes memory(kFeetechServos.goal_size);
  wire::FeetechWriter goal(memory, wire::feetech_order(series_));
  put_goal(goal, index, servo.goal, 1.0);
  SOMATO_TRY_VOID(write(servo, feetech::kGoalPosition, memory, exchange));
  return is_sts() ? write(servo, feetech::kAcceleration, {0}, exchange) : Result<void>();
}

Result<void> FeetechBus::start(wire::Exchange& exchange) {
  polled_ = servos_.size() - 1;  // the first tick polls the first servo
  to_poll_ = 0;
  answered_ = true;
  return PacketBus::start(exchange);
}

// The maker demands that the torque is off before a restart, which takes 0.8 s.
Result<void> FeetechBus::restart(const Servo& servo, wire::Exchange& exchange) {
  constexpr double kPollTime = 0.2;
  constexpr int kPolls = 10;
  SOMATO_TRY_VOID(exchange.send(packet([&](auto& to) {
    to.write(servo.id(), feetech::kTorqueEnable, std::array<std::uint8_t, 1>{0});
    to.reboot(servo.id());
  })));
  for (int i = 0; i < kPolls; ++i) {
    exchange.pause(kPollTime);
    if (read(servo, feetech::kTorqueEnable, 1, exchange)) break;
  }
  return {};
}

void FeetechBus::put_goal(wire::PacketWriter& to, std::size_t index, double goal, double seconds) {
  const double units = std::ceil(speed_to(index, goal, seconds) / kFeetechSpeedUnit);
  const double speed = std::clamp(units, 1.0, 655.0) * kFeetechSpeedUnit;
  const double time = std::clamp(std::round(seconds * 1000.0), 1.0, 9999.0);
  to.put16(wire::feetech_unsigned(static_cast<int>(goal)));
  to.put16(static_cast<std::uint16_t>(is_sts() ? 0.0 : time));
  to.put16(static_cast<std::uint16_t>(is_sts() ? speed : 0.0));
}

void FeetechBus::request_states(wire::PacketWriter& to, double seconds) {
  to_poll_ = servos_.size();
  waited_ += seconds;
  if (!is_sts()) {
    if (answered_ || waited_ >= kAnswerTime) poll_one(to);
    return;
  }
  to.sync_read(feetech::kPresentPosition, static_cast<std::uint16_t>(state_size()), ids_);
  coders_.states->expect_echo(to.written());
}

// Requests the state of the next servo. The remainder of an answer that was cut off must not be
// completed by the next one.
void FeetechBus::poll_one(wire::PacketWriter& to) {
  polled_ = (polled_ + 1) % servos_.size();
  ++reports_[polled_].unanswered;
  --to_poll_;
  answered_ = false;
  waited_ = 0.0;
  to.read(ids_[polled_], feetech::kPresentPosition, static_cast<std::uint16_t>(state_size()));
  coders_.states->clear();
  coders_.states->expect_echo(to.written());
}

std::span<const std::uint8_t> FeetechBus::follow_up() {
  if (is_sts() || !answered_ || to_poll_ == 0) return {};
  wire::PacketWriter& to = tick_writer();
  poll_one(to);
  return to.written();
}

// The sum protects a packet badly: two flags of STS servos and the range of SCS servos are checked
// as well, because they are wrong in most packets that lack a byte.
bool FeetechBus::is_state(std::size_t servo, const wire::Packet& packet) const {
  constexpr std::size_t kRegistered = 64 - feetech::kPresentPosition;
  constexpr std::size_t kMoving = 66 - feetech::kPresentPosition;
  if (packet.parameters.size() != state_size()) return false;
  if (is_sts()) return packet.parameters[kRegistered] <= 1 && packet.parameters[kMoving] <= 1;
  return servo == polled_ && word(packet.parameters, 0) <= 1023;
}

void FeetechBus::take_state(std::size_t servo, std::uint8_t error, Span state, double now) {
  ServoReport& report = reports_[servo];
  report.position = wire::feetech_signed(word(state, 0));
  report.temperature = state[feetech::kPresentTemperature - feetech::kPresentPosition];
  report.error = error;
  report.time = now;
  report.unanswered = 0;
  if (!is_sts()) return;
  const std::size_t current = feetech::kPresentCurrent - feetech::kPresentPosition;
  report.current = feetech::kCurrentUnit * wire::feetech_signed(word(state, current));
}

void FeetechBus::take(std::size_t servo, const wire::Packet& packet, double now) {
  if (!is_state(servo, packet)) return;
  take_state(servo, packet.error, packet.parameters, now);
  answered_ = true;
}

}  // namespace somato::devices
