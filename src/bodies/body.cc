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
              fmt::format("{:g} {} lies beyond the limits of '{}', {:g} to {:g} {}", target,
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
    if (auto within = check_target(servos[i], targets[i]); !within) return within;
  }
  return drive_to(targets);
}

Result<void> Body::step(double seconds) {
  require(std::isfinite(seconds) && seconds > 0.0, "Body::step: seconds must be above 0");
  if (state().time + seconds > limits_.longest) {
    return fail(ErrorKind::kData,
                fmt::format("it takes more than {:g} s of the body's time", limits_.longest), {},
                "shorten the times of its parameters, or allow it more time");
  }
  if (auto goes_on = check_stop(); !goes_on) return goes_on;
  return pass(seconds);
}

Result<void> Body::check_stop() const {
  if (!limits_.goes_on || limits_.goes_on()) return {};
  return fail(ErrorKind::kInterrupted, "exploring was stopped before its end");
}

Result<std::size_t> find_degree_of_freedom(const BodyDescription& description,
                                           std::string_view name) {
  return find_named(description.degrees_of_freedom, "degree of freedom", name);
}

Result<std::size_t> find_sensor(const BodyDescription& description, std::string_view name) {
  return find_named(description.sensors, "sensor", name);
}

}  // namespace somato
