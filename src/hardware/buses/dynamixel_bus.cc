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

constexpr std::size_t kDynamixelStateSize = 10;  // current, velocity and position
// As far as the temperature, which changes slowly: a longer answer would fill the line.
constexpr std::size_t kDynamixelLongStateSize =
    dynamixel_x::kPresentTemperature + 1 - dynamixel_x::kPresentCurrent;
constexpr double kDynamixelTemperatures = 0.2;           // s between two of them
constexpr double kDynamixelExtendedRange = 1'048'575.0;  // steps; the range with several turns

constexpr PacketServoKind kDynamixelServos{
    .maker = "Dynamixel",
    .series = "the X series",
    .highest_id = 252,
    .torque = dynamixel_x::kTorqueEnable,
    .return_delay = dynamixel_x::kReturnDelay,
    .goals = dynamixel_x::kVelocity,
    .goal_size = 8,  // profile velocity and goal position
    .refusal = 0xFF & ~dynamixel_error::kAlert,
    .error = "a hardware error",
    .errors = {"input voltage", "bit 1", "overheating", "motor encoder", "electrical shock",
               "overload"},
};

// The model whose `member` is `key`.
template <typename Member, typename Key>
const DynamixelModel* find_dynamixel_model(Member member, const Key& key) {
  const auto* found = std::find_if(kDynamixelModels.begin(), kDynamixelModels.end(),
                                   [&](const auto& model) { return model.*member == key; });
  return found == kDynamixelModels.end() ? nullptr : found;
}

unsigned low_first16(std::span<const std::uint8_t> bytes) {
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

std::int32_t low_first32(std::span<const std::uint8_t> bytes) {
  return static_cast<std::int32_t>(low_first16(bytes) | low_first16(bytes.subspan(2)) << 16);
}

}  // namespace

std::span<const DynamixelModel> dynamixel_models() {
  return kDynamixelModels;
}

BusInquiry dynamixel_inquiry() {
  BusInquiry inquiry;
  inquiry.writer = std::make_unique<wire::DynamixelWriter>();
  inquiry.decoder = std::make_unique<wire::DynamixelDecoder>();
  inquiry.request = [](wire::PacketWriter& to, std::uint8_t id) { to.ping(id); };
  inquiry.size = 3;
  inquiry.ids = kDynamixelServos.highest_id + 1;
  inquiry.name_of = [](unsigned model) { return name_of_model(kDynamixelModels, model); };
  return inquiry;
}

DynamixelBus::DynamixelBus(const std::vector<PacketServo>& servos)
    : PacketBus(
          kDynamixelServos, servos,
          {std::make_unique<wire::DynamixelWriter>(), std::make_unique<wire::DynamixelDecoder>(),
           std::make_unique<wire::DynamixelDecoder>()}) {
  for (const PacketServo& servo : servos) {
    require(
        servo.model.empty() || find_dynamixel_model(&DynamixelModel::name, servo.model),
        fmt::format("'{}' is not a model of the Dynamixel X series that is known", servo.model));
  }
  settings_.resize(servos.size());
  // Packets of 14 bytes and their parameters; each number may need a stuffing byte.
  const std::size_t goals = 14 + ids_.size() * (1 + kDynamixelServos.goal_size + 1);
  set_sizes(goals + 14 + ids_.size(), goals);
}

std::size_t DynamixelBus::bytes_per_tick() const {
  const std::size_t answer = 11 + kDynamixelLongStateSize + 7;  // with seven stuffing bytes
  return tick_.size() + ids_.size() * answer;
}

Result<void> DynamixelBus::write(const Servo& servo, std::uint16_t address, const Bytes& data,
                                 wire::Exchange& exchange) {
  const Bytes request = packet([&](auto& to) { to.write(servo.id(), address, data); });
  SOMATO_TRY_VOID(ask(servo, request, 0, exchange));
  return {};
}

Result<void> DynamixelBus::check_model(std::size_t index, wire::Exchange& exchange) {
  const Servo& servo = servos_[index];
  const Bytes ping = packet([&](auto& to) { to.ping(servo.id()); });
  SOMATO_TRY(const auto known, ask(servo, ping, 3, exchange));
  const unsigned number = low_first16(known.data);
  const DynamixelModel* found = find_dynamixel_model(&DynamixelModel::number, number);
  const DynamixelModel* declared =
      find_dynamixel_model(&DynamixelModel::name, servo.declared.model);
  if (!found || (declared && declared != found)) {
    return fail(ErrorKind::kData,
                fmt::format("the servo is a model {} ({}){}", found ? found->name : "unknown",
                            number, declared ? ", not the declared one" : ""),
                servo.place(), "correct the model or the id in the device file");
  }
  settings_[index].current_unit = found->current_unit;
  return {};
}

// A servo that does not answer writes is set to do so; the setting is no part of the EEPROM.
Result<void> DynamixelBus::check_modes(std::size_t index, wire::Exchange& exchange) {
  const Servo& servo = servos_[index];
  const Bytes request = packet([&](auto& to) {
    to.write(servo.id(), dynamixel_x::kStatusReturn, std::array<std::uint8_t, 1>{2});
  });
  SOMATO_TRY_VOID(exchange.clear());
  SOMATO_TRY_VOID(exchange.send(request));
  SOMATO_TRY(const auto answer, read(servo, dynamixel_x::kReturnDelay, 3, exchange));
  const Bytes& modes = answer.data;
  const int mode = modes[2];
  if (mode != 3 && mode != 4 && mode != 5) {
    return fail(ErrorKind::kData, fmt::format("the servo does not hold positions (mode {})", mode),
                servo.place(),
                "set its operating mode (address 11) to 3, 4 or 5 with the maker's program");
  }
  settings_[index].timed = (modes[1] & dynamixel_x::kTimeBasedProfile) != 0;
  warn_of_delay(servo, modes[0]);
  if ((modes[1] & dynamixel_x::kTorqueOnByGoal) != 0) {
    warnings_.push_back(
        fmt::format("{}: each goal switches its torque on (bit 3 of address 10)", servo.place()));
  }
  return read_limits(index, mode == 3, exchange);
}

Result<void> DynamixelBus::read_limits(std::size_t index, bool one_turn, wire::Exchange& exchange) {
  Servo& servo = servos_[index];
  SOMATO_TRY(const auto limits, read(servo, dynamixel_x::kVelocityLimit, 12, exchange));
  const Span numbers = limits.data;
  settings_[index].fastest = std::clamp(low_first32(numbers), 1, 32767);
  servo.highest = one_turn ? low_first32(numbers.subspan(4)) : kDynamixelExtendedRange;
  servo.lowest = one_turn ? low_first32(numbers.subspan(8)) : -kDynamixelExtendedRange;
  if (servo.lowest <= servo.highest) return {};
  return fail(ErrorKind::kData,
              fmt::format("the lowest position of the servo, {}, is above the highest, {}",
                          servo.lowest, servo.highest),
              servo.place(), "correct its position limits (addresses 48 and 52)");
}

Result<void> DynamixelBus::check(std::size_t index, wire::Exchange& exchange) {
  SOMATO_TRY_VOID(check_model(index, exchange));
  SOMATO_TRY_VOID(check_modes(index, exchange));
  SOMATO_TRY(const auto error, read(servos_[index], dynamixel_x::kHardwareError, 1, exchange));
  return check_error(servos_[index], error.data[0]);
}

Result<void> DynamixelBus::measure(std::size_t index, wire::Exchange& exchange) {
  SOMATO_TRY(const auto state,
             read(servos_[index], dynamixel_x::kPresentCurrent, kDynamixelStateSize, exchange));
  reports_[index].error = 0;
  take_state(index, state.data, exchange.now());
  return {};
}

// Without acceleration, and with the lowest velocity.
Result<void> DynamixelBus::write_goal(std::size_t index, wire::Exchange& exchange) {
  const auto goal = static_cast<std::int32_t>(servos_[index].goal);
  Bytes profile{0, 0, 0, 0, 1, 0, 0, 0};
  for (int bit = 0; bit < 32; bit += 8) {
    profile.push_back(static_cast<std::uint8_t>(goal >> bit & 0xFF));
  }
  return write(servos_[index], dynamixel_x::kAcceleration, profile, exchange);
}

Result<void> DynamixelBus::start(wire::Exchange& exchange) {
  errors_requested_ = false;
  since_temperatures_ = 0.0;
  return PacketBus::start(exchange);
}

Result<void> DynamixelBus::restart(const Servo& servo, wire::Exchange& exchange) {
  constexpr double kPollTime = 0.1;
  constexpr std::size_t kPolls = 30;
  SOMATO_TRY_VOID(exchange.send(packet([&](auto& to) { to.reboot(servo.id()); })));
  exchange.pause(kPollTime);
  wire::PacketDecoder& decoder = *coders_.answers;
  decoder.clear();
  const Bytes ping = packet([&](auto& to) { to.ping(servo.id()); });
  SOMATO_TRY_VOID(exchange.request(ping, kPollTime, kPolls, [&](auto bytes) {
    decoder.put(bytes);
    return decoder.next_status().has_value();
  }));
  return {};
}

// At least 1, because 0 stands for no profile.
std::uint32_t DynamixelBus::profile_velocity(std::size_t index, double goal, double seconds) {
  const Settings& settings = settings_[index];
  if (settings.timed) return static_cast<std::uint32_t>(std::clamp(seconds * 1000.0, 1.0, 32737.0));
  const double velocity = std::ceil(speed_to(index, goal, seconds) / dynamixel_x::kVelocityUnit);
  return static_cast<std::uint32_t>(std::clamp(velocity, 1.0, settings.fastest));
}

void DynamixelBus::put_goal(wire::PacketWriter& to, std::size_t index, double goal,
                            double seconds) {
  to.put32(profile_velocity(index, goal, seconds));
  to.put32(static_cast<std::uint32_t>(static_cast<std::int32_t>(goal)));
}

// Errors are requested every second time at most, so that the states stay known if a servo does not
// answer.
void DynamixelBus::request_states(wire::PacketWriter& to, double seconds) {
  errors_requested_ = !errors_requested_ && error_is_unknown();
  since_temperatures_ += seconds;
  if (errors_requested_) {
    to.sync_read(dynamixel_x::kHardwareError, 1, ids_);
  } else {
    to.sync_read(dynamixel_x::kPresentCurrent, size_of_next_state(), ids_);
  }
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

void DynamixelBus::take_state(std::size_t servo, Span state, double now) {
  ServoReport& report = reports_[servo];
  const auto current = static_cast<std::int16_t>(low_first16(state));
  report.current = current * settings_[servo].current_unit;
  report.position = low_first32(state.subspan(6));
  report.time = now;
}

void DynamixelBus::take(std::size_t servo, const wire::Packet& packet, double now) {
  const std::size_t size = packet.parameters.size();
  std::uint8_t& error = reports_[servo].error;
  if ((packet.error & dynamixel_error::kAlert) == 0) {
    error = 0;
  } else if (size == 1) {
    error = packet.parameters[0];
  } else if (error == 0) {
    error = kUnknownError;
  }
  const bool is_long = size == kDynamixelLongStateSize;
  if (is_long || size == kDynamixelStateSize) take_state(servo, packet.parameters, now);
  if (is_long) reports_[servo].temperature = packet.parameters.back();
}

}  // namespace somato::devices
