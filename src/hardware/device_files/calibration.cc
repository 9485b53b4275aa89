#include "hardware/device_files/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardware/device_files/device_text.h"

namespace somato::devices {

void Calibration::set_zero(double on_bus) {
  // The limits stay where they are on the bus.
  least_ = least_.value_or(servo_.on_bus(servo_.least));
  most_ = most_.value_or(servo_.on_bus(servo_.most));
  rest_ = rest_.value_or(servo_.on_bus(servo_.resting()));
  servo_.zero = on_bus;
}

Result<void> Calibration::set_position(double on_bus, double position) {
  if (position == 0.0 || on_bus == servo_.zero) {
    return fail(ErrorKind::kData, "a scale requires a position away from 0", servo_.name,
                "move the servo away from its zero, and give the position that it has there");
  }
  set_zero(servo_.zero);
  servo_.scale = (on_bus - servo_.zero) / position;
  return {};
}

ServoSettings Calibration::servo() const {
  ServoSettings found = servo_;
  if (least_) found.least = servo_.from_bus(*least_);
  if (most_) found.most = servo_.from_bus(*most_);
  if (rest_) found.rest = servo_.from_bus(*rest_);
  if (found.least > found.most) std::swap(found.least, found.most);
  if (found.rest) found.rest = std::clamp(*found.rest, found.least, found.most);
  return found;
}

Result<std::string> Calibration::in_text(std::string_view text, std::string_view where) const {
  const ServoSettings found = servo();
  const std::string table = "servo." + found.name;
  std::string changed(text);
  const auto set = [&](std::string_view key, double value) {
    constexpr double kPrecision = 1e4;
    const double rounded = std::round(value * kPrecision) / kPrecision;
    changed = with_key(changed, table, key, fmt::format("{}", rounded));
  };
  set("zero", found.zero);
  set("scale", found.scale);
  set("least", found.least);
  set("most", found.most);
  if (found.rest) set("rest", *found.rest);
  SOMATO_TRY_VOID(parse_device_file(changed, where));
  return changed;
}

Result<DeviceFile> one_servo(const DeviceFile& file, std::string_view name) {
  DeviceFile one = file;
  std::vector<std::string> known;
  one.servos.clear();
  for (const ServoSettings& servo : file.servos) {
    known.push_back(servo.name);
    if (servo.name == name) one.servos.push_back(servo);
  }
  if (one.servos.empty()) return fail(unknown_name("servo", name, file.settings.name, known));
  ServoSettings& servo = one.servos.front();
  const BusTraits& bus = traits_of(one.servo_line->bus);
  const double resting = servo.resting();
  servo.least = std::min(servo.from_bus(bus.lowest), servo.from_bus(bus.highest));
  servo.most = std::max(servo.from_bus(bus.lowest), servo.from_bus(bus.highest));
  servo.rest = std::clamp(resting, servo.least, servo.most);
  constexpr double kSeconds = 20.0;  // For the whole way, so that a hand can be withdrawn.
  servo.fastest = std::min(servo.fastest, (servo.most - servo.least) / kSeconds);
  one.frame_line.reset();
  one.microphone.reset();
  one.safety.sensor.clear();
  one.safety.limit.reset();
  SensorSettings position;
  position.name = "position";
  position.from = SensorOrigin::kDriver;
  position.servos = {servo.name};
  one.sensors = {position};
  return one;
}

}  // namespace somato::devices
