#include "hardware/buses/dynamixel_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

namespace dynamixel_x = wire::dynamixel_x;
namespace dynamixel_error = wire::dynamixel_error;

constexpr double kLoadOnly = std::numeric_limits<double>::quiet_NaN();
constexpr double kMilli = 1.0;    // mA, the servos with a gear of 22 mm
constexpr double kMedium = 2.69;  // mA, X430 and X540

constexpr std::array kDynamixelModels = std::to_array<DynamixelModel>({
    {"XH430-W350", 1000, kMedium},
    {"XH430-W210", 1010, kMedium},
    {"XM430-W350", 1020, kMedium},
    {"XM430-W210", 1030, kMedium},
    {"XL430-W250", 1060, kLoadOnly},
    {"XC430-W150", 1070, kLoadOnly},
    {"XC430-W240", 1080, kLoadOnly},
    {"2XL430-W250", 1090, kLoadOnly},
    {"XM540-W270", 1120, kMedium},
    {"XM540-W150", 1130, kMedium},
    {"2XC430-W250", 1160, kLoadOnly},
    {"XL330-M077", 1190, kMilli},
    {"XL330-M288", 1200, kMilli},
    {"XC330-T181", 1210, kMilli},
    {"XC330-T288", 1220, kMilli},
    {"XC330-M181", 1230, kMilli},
    {"XC330-M288", 1240, kMilli},
});

constexpr std::uint8_t kNoDynamixel = 0xFF;
constexpr std::size_t kDynamixelStateSize = 10;  // current, velocity and position
// As far as the temperature, which changes slowly: a longer answer would fill the line.
constexpr std::size_t kDynamixelLongStateSize =
    dynamixel_x::kPresentTemperature + 1 - dynamixel_x::kPresentCurrent;
constexpr double kDynamixelTemperatures = 0.2;  // s between two of them
constexpr std::size_t kDynamixelGoalSize = 8;   // profile velocity and goal position
constexpr double kDynamixelAnswerTime = 0.05;   // s; an adapter may collect bytes for 16 ms
constexpr std::size_t kDynamixelAttempts = 3;
constexpr double kDynamixelExtendedRange = 1'048'575.0;  // steps; the range with several turns

const DynamixelModel* find_dynamixel_model(std::string_view name) {
  const auto* found = std::find_if(kDynamixelModels.begin(), kDynamixelModels.end(),
                                   [&](const auto& model) { return model.name == name; });
  return found == kDynamixelModels.end() ? nullptr : found;
}

const DynamixelModel* find_dynamixel_model(unsigned number) {
  const auto* found = std::find_if(kDynamixelModels.begin(), kDynamixelModels.end(),
                                   [&](const auto& model) { return model.number == number; });
  return found == kDynamixelModels.end() ? nullptr : found;
}

unsigned low_first16(std::span<const std::uint8_t> bytes) {
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

std::int32_t low_first32(std::span<const std::uint8_t> bytes) {
  return static_cast<std::int32_t>(low_first16(bytes) | low_first16(bytes.subspan(2)) << 16);
}

std::string dynamixel_place(const DynamixelServo& servo) {
  return fmt::format("servo with id {}", servo.id);
}

std::string dynamixel_error_names(std::uint8_t bits) {
  constexpr std::array<std::string_view, 6> kNames{
      "input voltage", "bit 1", "overheating", "motor encoder", "electrical shock", "overload"};
  std::string text;
  for (std::size_t bit = 0; bit < kNames.size(); ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    text += text.empty() ? "" : ", ";
    text += kNames[bit];
  }
  return text;
}

// The bytes of one packet.
template <typename Fill>
std::vector<std::uint8_t> dynamixel_packet(const Fill& fill) {
  std::array<std::uint8_t, 64> memory{};
  wire::DynamixelWriter writer(memory);
  fill(writer);
  return {writer.written().begin(), writer.written().end()};
}

// Enough packets for one to be read whole by a servo that still waits for the `longest` packet.
std::vector<std::uint8_t> dynamixel_relax(std::size_t longest) {
  const auto once = dynamixel_packet([](auto& to) {
    to.write(wire::kDynamixelEveryone, dynamixel_x::kTorqueEnable, std::array<std::uint8_t, 1>{0});
  });
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < longest / once.size() + 2; ++i) {
    bytes.insert(bytes.end(), once.begin(), once.end());
  }
  return bytes;
}

}  // namespace

std::span<const DynamixelModel> dynamixel_models() {
  return kDynamixelModels;
}

DynamixelBus::DynamixelBus(std::vector<DynamixelServo> servos) : ServoBus(servos.size()) {
  require(!servos.empty(), "a bus has at least one servo");
  servo_of_id_.fill(kNoDynamixel);
  for (DynamixelServo& servo : servos) {
    require(servo.id <= 252, "the id of a Dynamixel servo is at most 252");
    require(servo_of_id_[servo.id] == kNoDynamixel, "two servos have the same id");
    require(
        servo.model.empty() || find_dynamixel_model(servo.model),
        fmt::format("'{}' is not a model of the Dynamixel X series that is known", servo.model));
    servo_of_id_[servo.id] = static_cast<std::uint8_t>(ids_.size());
    ids_.push_back(servo.id);
    servos_.push_back({.declared = std::move(servo)});
  }
  // Packets of 14 bytes and their parameters; each number may need a stuffing byte.
  const std::size_t goals = 14 + ids_.size() * (1 + kDynamixelGoalSize + 1);
  tick_.resize(goals + 14 + ids_.size());
  relax_ = dynamixel_relax(goals);
}

std::size_t DynamixelBus::bytes_per_tick() const {
  const std::size_t answer = 11 + kDynamixelLongStateSize + 7;  // with seven stuffing bytes
  return tick_.size() + ids_.size() * answer;
}

// The data of the answer to a request, which have `size` bytes.
Result<DynamixelBus::Bytes> DynamixelBus::exchange_with(const Servo& servo,
                                                        std::span<const std::uint8_t> request,
                                                        std::size_t size,
                                                        wire::Exchange& exchange) const {
  wire::DynamixelDecoder decoder;
  Bytes data;
  std::uint8_t refusal = 0;
  const auto take = [&](std::span<const std::uint8_t> bytes) {
    decoder.put(bytes);
    while (const auto packet = decoder.next_status()) {
      refusal = packet->error & static_cast<std::uint8_t>(~dynamixel_error::kAlert);
      data.assign(packet->parameters.begin(), packet->parameters.end());
      if (packet->id == servo.declared.id && (refusal != 0 || data.size() == size)) return true;
    }
    return false;
  };
  SOMATO_TRY(const bool answered,
             exchange.request(request, kDynamixelAnswerTime, kDynamixelAttempts, take));
  if (!answered) {
    return fail(ErrorKind::kSystem, "the servo does not answer", dynamixel_place(servo.declared),
                "check its power, its cable, its id and the baud rate");
  }
  if (refusal != 0) {
    return fail(ErrorKind::kData, fmt::format("the servo refuses a request (error {})", refusal),
                dynamixel_place(servo.declared), "check that it is a servo of the X series");
  }
  return data;
}

Result<DynamixelBus::Bytes> DynamixelBus::read(const Servo& servo, std::uint16_t address,
                                               std::size_t size, wire::Exchange& exchange) const {
  const auto request = dynamixel_packet(
      [&](auto& to) { to.read(servo.declared.id, address, static_cast<std::uint16_t>(size)); });
  return exchange_with(servo, request, size, exchange);
}

Result<void> DynamixelBus::write(const Servo& servo, std::uint16_t address,
                                 std::span<const std::uint8_t> data,
                                 wire::Exchange& exchange) const {
  const auto request =
      dynamixel_packet([&](auto& to) { to.write(servo.declared.id, address, data); });
  SOMATO_TRY_VOID(exchange_with(servo, request, 0, exchange));
  return {};
}

Result<void> DynamixelBus::check_model(Servo& servo, wire::Exchange& exchange) const {
  const auto ping = dynamixel_packet([&](auto& to) { to.ping(servo.declared.id); });
  SOMATO_TRY(const auto known, exchange_with(servo, ping, 3, exchange));
  const unsigned number = low_first16(known);
  const DynamixelModel* found = find_dynamixel_model(number);
  const DynamixelModel* declared = find_dynamixel_model(servo.declared.model);
  if (!found || (declared && declared != found)) {
    return fail(ErrorKind::kData,
                fmt::format("the servo is a model {} ({}){}", found ? found->name : "unknown",
                            number, declared ? ", not the declared one" : ""),
                dynamixel_place(servo.declared), "correct the model or the id in the device file");
  }
  servo.current_unit = found->current_unit;
  return {};
}

// A servo that does not answer writes is set to do so; the setting is no part of the EEPROM.
Result<void> DynamixelBus::check_modes(Servo& servo, wire::Exchange& exchange) {
  const auto request = dynamixel_packet([&](auto& to) {
    to.write(servo.declared.id, dynamixel_x::kStatusReturn, std::array<std::uint8_t, 1>{2});
  });
  SOMATO_TRY_VOID(exchange.clear());
  SOMATO_TRY_VOID(exchange.send(request));
  SOMATO_TRY(const auto modes, read(servo, dynamixel_x::kReturnDelay, 3, exchange));
  const int mode = modes[2];
  if (mode != 3 && mode != 4 && mode != 5) {
    return fail(ErrorKind::kData, fmt::format("the servo does not hold positions (mode {})", mode),
                dynamixel_place(servo.declared),
                "set its operating mode (address 11) to 3, 4 or 5 with the maker's program");
  }
  servo.timed = (modes[1] & dynamixel_x::kTimeBasedProfile) != 0;
  if (modes[0] != 0) {
    warnings_.push_back(
        fmt::format("{}: it waits {} us before each answer; a return delay "
                    "(address 9) of 0 makes the bus faster",
                    dynamixel_place(servo.declared), 2 * modes[0]));
  }
  if ((modes[1] & dynamixel_x::kTorqueOnByGoal) != 0) {
    warnings_.push_back(fmt::format("{}: each goal switches its torque on (bit 3 of address 10)",
                                    dynamixel_place(servo.declared)));
  }
  return read_limits(servo, mode == 3, exchange);
}

Result<void> DynamixelBus::read_limits(Servo& servo, bool one_turn,
                                       wire::Exchange& exchange) const {
  SOMATO_TRY(const auto limits, read(servo, dynamixel_x::kVelocityLimit, 12, exchange));
  const auto numbers = std::span<const std::uint8_t>(limits);
  servo.fastest = std::clamp(low_first32(numbers), 1, 32767);
  servo.highest = one_turn ? low_first32(numbers.subspan(4)) : kDynamixelExtendedRange;
  servo.lowest = one_turn ? low_first32(numbers.subspan(8)) : -kDynamixelExtendedRange;
  if (servo.lowest <= servo.highest) return {};
  return fail(ErrorKind::kData,
              fmt::format("the lowest position of the servo, {}, is above the highest, {}",
                          servo.lowest, servo.highest),
              dynamixel_place(servo.declared), "correct its position limits (addresses 48 and 52)");
}

Result<void> DynamixelBus::check_error(const Servo& servo, wire::Exchange& exchange) const {
  SOMATO_TRY(const auto error, read(servo, dynamixel_x::kHardwareError, 1, exchange));
  if (error[0] == 0) return {};
  return fail(
      ErrorKind::kSystem,
      fmt::format("the servo reports a hardware error ({})", dynamixel_error_names(error[0])),
      dynamixel_place(servo.declared),
      "remove the cause, then run 'somato device check FILE --reboot'");
}

Result<void> DynamixelBus::check(Servo& servo, wire::Exchange& exchange) {
  SOMATO_TRY_VOID(check_model(servo, exchange));
  SOMATO_TRY_VOID(check_modes(servo, exchange));
  return check_error(servo, exchange);
}

// The goal comes before the torque, so that nothing moves.
Result<void> DynamixelBus::hold(std::size_t index, wire::Exchange& exchange) {
  Servo& servo = servos_[index];
  SOMATO_TRY(const auto state,
             read(servo, dynamixel_x::kPresentCurrent, kDynamixelStateSize, exchange));
  reports_[index].error = 0;
  take_state(index, state, exchange.now());
  servo.goal = reports_[index].position;
  if (servo.goal < servo.lowest || servo.goal > servo.highest) {
    return fail(ErrorKind::kData,
                fmt::format("the servo stands at {}, outside its limits {} to {}", servo.goal,
                            servo.lowest, servo.highest),
                dynamixel_place(servo.declared), "move it by hand between its limits");
  }
  std::array<std::uint8_t, 12> profile{0, 0, 0, 0, 1};  // no acceleration, lowest velocity
  std::copy_n(state.begin() + 6, 4, profile.begin() + 8);
  SOMATO_TRY_VOID(write(servo, dynamixel_x::kAcceleration, profile, exchange));
  return write(servo, dynamixel_x::kTorqueEnable, std::array<std::uint8_t, 1>{1}, exchange);
}

Result<void> DynamixelBus::hold_all(wire::Exchange& exchange) {
  for (std::size_t i = 0; i < servos_.size(); ++i) SOMATO_TRY_VOID(hold(i, exchange));
  return {};
}

Result<void> DynamixelBus::start(wire::Exchange& exchange) {
  warnings_.clear();
  decoder_.clear();
  errors_requested_ = false;
  since_temperatures_ = 0.0;
  for (Servo& servo : servos_) SOMATO_TRY_VOID(check(servo, exchange));
  auto held = hold_all(exchange);
  if (!held) SOMATO_TRY_VOID(exchange.send(relax_));
  return held;
}

Result<void> DynamixelBus::reboot(std::size_t servo, wire::Exchange& exchange) {
  constexpr double kPollTime = 0.1;
  constexpr std::size_t kPolls = 30;
  Servo& it = servos_.at(servo);
  SOMATO_TRY_VOID(exchange.send(dynamixel_packet([&](auto& to) { to.reboot(it.declared.id); })));
  exchange.pause(kPollTime);
  wire::DynamixelDecoder decoder;
  const auto ping = dynamixel_packet([&](auto& to) { to.ping(it.declared.id); });
  SOMATO_TRY_VOID(exchange.request(ping, kPollTime, kPolls, [&](auto bytes) {
    decoder.put(bytes);
    return decoder.next_status().has_value();
  }));
  SOMATO_TRY_VOID(check(it, exchange));
  return hold(servo, exchange);
}

// At least 1, because 0 stands for no profile.
std::uint32_t DynamixelBus::profile_velocity(std::size_t index, double goal, double seconds) {
  Servo& servo = servos_[index];
  if (servo.timed) return static_cast<std::uint32_t>(std::clamp(seconds * 1000.0, 1.0, 32737.0));
  const double steps = servo.speed.next(goal, servo.goal, reports_[index].position, seconds);
  const double velocity = std::ceil(steps / dynamixel_x::kVelocityUnit);
  return static_cast<std::uint32_t>(std::clamp(velocity, 1.0, servo.fastest));
}

void DynamixelBus::write_goals(wire::DynamixelWriter& to, std::span<const double> positions,
                               double seconds) {
  to.begin_sync_write(dynamixel_x::kVelocity, kDynamixelGoalSize);
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    Servo& servo = servos_[i];
    if (!std::isfinite(positions[i])) continue;
    const double goal = std::round(std::clamp(positions[i], servo.lowest, servo.highest));
    to.put8(servo.declared.id);
    to.put32(profile_velocity(i, goal, seconds));
    to.put32(static_cast<std::uint32_t>(static_cast<std::int32_t>(goal)));
    servo.goal = goal;
  }
  to.end();
}

std::span<const std::uint8_t> DynamixelBus::tick(std::span<const double> positions,
                                                 double seconds) {
  require(positions.size() == servos_.size(), "there is one position for each servo");
  wire::DynamixelWriter to(tick_);
  const auto given = [](double position) { return std::isfinite(position); };
  if (std::any_of(positions.begin(), positions.end(), given)) write_goals(to, positions, seconds);
  // Every second request at most, so that the states stay known if a servo does not answer.
  errors_requested_ = !errors_requested_ && error_is_unknown();
  since_temperatures_ += seconds;
  if (errors_requested_) {
    to.sync_read(dynamixel_x::kHardwareError, 1, ids_);
  } else {
    to.sync_read(dynamixel_x::kPresentCurrent, size_of_next_state(), ids_);
  }
  return to.written();
}

std::uint16_t DynamixelBus::size_of_next_state() {
  if (since_temperatures_ < kDynamixelTemperatures) return kDynamixelStateSize;
  since_temperatures_ = 0.0;
  return kDynamixelLongStateSize;
}

bool DynamixelBus::error_is_unknown() const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [](const ServoReport& report) { return report.error == kUnknownError; });
}

void DynamixelBus::take_state(std::size_t servo, std::span<const std::uint8_t> state, double now) {
  ServoReport& report = reports_[servo];
  const auto current = static_cast<std::int16_t>(low_first16(state));
  report.current = current * servos_[servo].current_unit;
  report.position = low_first32(state.subspan(6));
  report.time = now;
}

void DynamixelBus::receive(std::span<const std::uint8_t> bytes, double now) {
  decoder_.put(bytes);
  while (const auto packet = decoder_.next_status()) {
    const std::uint8_t servo = servo_of_id_[packet->id];
    if (servo == kNoDynamixel) continue;
    std::uint8_t& error = reports_[servo].error;
    if ((packet->error & dynamixel_error::kAlert) == 0) {
      error = 0;
    } else if (packet->parameters.size() == 1) {
      error = packet->parameters[0];
    } else if (error == 0) {
      error = kUnknownError;
    }
    const std::size_t size = packet->parameters.size();
    if (size == kDynamixelStateSize || size == kDynamixelLongStateSize) {
      take_state(servo, packet->parameters, now);
    }
    if (size == kDynamixelLongStateSize) reports_[servo].temperature = packet->parameters.back();
  }
}

}  // namespace somato::devices
