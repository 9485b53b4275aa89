#include "hardware/devices/servo_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace somato::devices {
namespace {

double sign_of(double way) {
  return way == 0.0 ? 0.0 : std::copysign(1.0, way);
}

double middle_of(std::array<double, 3> values) {
  std::sort(values.begin(), values.end());
  return values[1];
}

tl::unexpected<Error> fault_of(const ServoSettings& servo, const std::string& what,
                               const char* advice) {
  return fail(ErrorKind::kData, fmt::format("the servo '{}' {}", servo.name, what), servo.name,
              advice);
}

}  // namespace

// A hand that closes presses on what it explores, and so does the stick of a probe.
ServoWatch::ServoWatch(const DeviceFile& file)
    : file_(file),
      may_be_blocked_(file.settings.explore == ExploringMethod::kClosing ||
                      file.settings.explore == ExploringMethod::kPressing),
      servos_(file.servos.size()) {}

void ServoWatch::begin() {
  std::fill(servos_.begin(), servos_.end(), Servo{});
  obeys_ = true;
}

Result<void> ServoWatch::check(std::span<const double> commanded,
                               std::span<const ServoReport> reports) {
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    if (reports[i].time != servos_[i].time) SOMATO_TRY_VOID(take(i, commanded[i], reports[i]));
  }
  return {};
}

Result<void> ServoWatch::take(std::size_t servo, double commanded, const ServoReport& report) {
  Servo& seen = servos_[servo];
  const double longest = file_.safety.unmoved / 4.0;
  const double passed = std::min(report.time - std::exchange(seen.time, report.time), longest);
  SOMATO_TRY_VOID(check_heat(servo, report));
  if (!std::isfinite(report.position)) return {};
  seen.last[seen.count++ % kReports] = file_.servos[servo].from_bus(report.position);
  if (seen.count < kReports) return {};
  return check_position(servo, commanded, passed);
}

Result<void> ServoWatch::check_heat(std::size_t servo, const ServoReport& report) {
  const bool is_hot = report.temperature > file_.safety.hottest;
  servos_[servo].hot = is_hot ? servos_[servo].hot + 1 : 0;
  if (servos_[servo].hot < kReports) return {};
  return fault_of(file_.servos[servo],
                  fmt::format("has a temperature of {:g} degrees Celsius, above {:g}",
                              report.temperature, file_.safety.hottest),
                  "remove its load and let it cool; 'hottest' of [safety] is the limit");
}

Result<void> ServoWatch::check_position(std::size_t servo, double commanded, double passed) {
  Servo& seen = servos_[servo];
  const double before = std::exchange(seen.measured, middle_of(seen.last));
  SOMATO_TRY_VOID(check_limits(servo));
  if (seen.count == kReports) {
    seen.commanded = commanded;
    seen.begun_at = seen.still_at = seen.measured;
    return {};
  }
  note_movement(servo, commanded, passed);
  SOMATO_TRY_VOID(check_drift(servo, before));
  return check_movement(servo);
}

double ServoWatch::deviation(std::size_t servo) const {
  const ServoSettings& settings = file_.servos[servo];
  return file_.safety.deviation * (settings.most - settings.least);
}

// Where it stood when its command began to lead it in another direction is known as long as it has
// followed: what blocks it later does not change that.
void ServoWatch::note_movement(std::size_t servo, double commanded, double passed) {
  Servo& seen = servos_[servo];
  const double permitted = deviation(servo);
  const double direction = sign_of(commanded - std::exchange(seen.commanded, commanded));
  seen.still_for += passed;
  seen.behind_for += passed;
  if (std::abs(seen.measured - seen.still_at) > permitted / 4.0) {
    seen.still_at = seen.measured;
    seen.still_for = 0.0;
  }
  if (std::abs(commanded - seen.measured) > permitted) return;
  seen.behind_for = 0.0;
  if (direction == seen.direction && direction != 0.0) return;
  seen.begun_at = seen.measured;
  seen.direction = direction;
}

Result<void> ServoWatch::check_limits(std::size_t servo) {
  const ServoSettings& settings = file_.servos[servo];
  const double beyond = file_.safety.beyond * (settings.most - settings.least);
  const double at = servos_[servo].measured;
  if (at >= settings.least - beyond && at <= settings.most + beyond) return {};
  obeys_ = false;
  return fault_of(settings,
                  fmt::format("is at {:.1f} {}, outside its limits, {:g} to {:g}", at,
                              settings.unit, settings.least, settings.most),
                  "move it into its limits by hand with the power off, and check its horn, 'zero' "
                  "and 'scale' ('somato device calibrate FILE')");
}

// The way back towards the command counts as well, so that small movements do not add up.
Result<void> ServoWatch::check_drift(std::size_t servo, double before) {
  Servo& seen = servos_[servo];
  const double farther =
      std::abs(seen.measured - seen.commanded) - std::abs(before - seen.commanded);
  seen.away = std::max(0.0, seen.away + farther);
  if (seen.away <= deviation(servo)) return {};
  obeys_ = false;
  const ServoSettings& settings = file_.servos[servo];
  return fault_of(settings,
                  fmt::format("moves away from its command: it is at {0:.1f} {1}, and is sent to "
                              "{2:.1f} {1}",
                              seen.measured, settings.unit, seen.commanded),
                  "check its power and its gears, and that nothing pushes it; 'deviation' of "
                  "[safety] is what is permitted");
}

// The object may block a servo on its way; one that has never moved is stuck.
Result<void> ServoWatch::check_movement(std::size_t servo) const {
  const Servo& seen = servos_[servo];
  const double still = std::min(seen.still_for, seen.behind_for);
  const bool has_moved = std::abs(seen.measured - seen.begun_at) > deviation(servo) / 2.0;
  if (still <= file_.safety.unmoved || (may_be_blocked_ && has_moved)) return {};
  const ServoSettings& settings = file_.servos[servo];
  return fault_of(settings,
                  fmt::format("does not move: it has been at {0:.1f} {1} for {2:.2f} s, and is "
                              "sent to {3:.1f} {1}",
                              seen.measured, settings.unit, still, seen.commanded),
                  "remove what blocks it, and check its gears and its power; 'deviation' and "
                  "'unmoved' of [safety] are what is permitted");
}

}  // namespace somato::devices
