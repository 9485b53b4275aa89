#include "somato/bodies/body.h"

#include <fmt/format.h>

#include <cmath>

#include "somato/core/check.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

Result<void> check_target(const DegreeOfFreedom& servo, double target) {
  if (target >= servo.least && target <= servo.most) return {};
  return fail(ErrorKind::kData,
              fmt::format("{:g} {} is outside the limits of '{}', {:g} to {:g} {}", target,
                          servo.unit, servo.name, servo.least, servo.most, servo.unit),
              servo.name, "command a position within the limits");
}

template <typename Named>
Result<std::size_t> find_named(const std::vector<Named>& all, const char* what,
                               std::string_view name) {
  std::vector<std::string> known;
  known.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
    known.push_back(all[i].name);
  }
  return fail(unknown_name(what, name, {}, known));
}

}  // namespace

Result<void> Body::command(std::span<const double> targets) {
  const auto& servos = description().degrees_of_freedom;
  require(targets.size() == servos.size(), "Body::command: one target for each degree of freedom");
  for (std::size_t i = 0; i < servos.size(); ++i) {
    SOMATO_TRY_VOID(check_target(servos[i], targets[i]));
  }
  return drive_to(targets);
}

Result<void> Body::step(double seconds, Readings readings) {
  require(std::isfinite(seconds) && seconds > 0.0, "Body::step: seconds must be above 0");
  if (state().time + seconds > limits_.longest) {
    return fail(
        ErrorKind::kData,
        fmt::format("the exploration takes more than {:g} s of the body's time", limits_.longest),
        {}, "reduce the times in its parameters, or allow more time");
  }
  SOMATO_TRY_VOID(check_stop());
  return pass(seconds).and_then(
      [&] { return after_step_ ? after_step_(readings) : Result<void>(); });
}

Result<void> Body::check_stop() const {
  if (!limits_.should_continue || limits_.should_continue()) return {};
  return fail(ErrorKind::kInterrupted, "exploring was interrupted");
}

Result<std::size_t> find_degree_of_freedom(const BodyDescription& description,
                                           std::string_view name) {
  return find_named(description.degrees_of_freedom, "degree of freedom", name);
}

Result<std::size_t> find_sensor(const BodyDescription& description, std::string_view name) {
  return find_named(description.sensors, "sensor", name);
}

}  // namespace somato
