#include "bodies/body/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace somato {
namespace {

constexpr double kStep = 0.05;    // s; interval of checks whether all have arrived
constexpr double kArrived = 0.1;  // deg or mm; a pulse of a hobby servo is about as wide

// The first servo that is still on its way.
std::optional<std::size_t> still_moving(const Body& body, std::span<const double> targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!has_arrived(body.state().positions[i], targets[i])) return i;
  }
  return std::nullopt;
}

tl::unexpected<Error> never_arrived(const Body& body, std::size_t servo, double target,
                                    double waited) {
  const DegreeOfFreedom& one = body.description().degrees_of_freedom[servo];
  return fail(ErrorKind::kData,
              fmt::format("'{}' did not reach {:g} {}: it was at {:g} after {:g} s", one.name,
                          target, one.unit, body.state().positions[servo], waited),
              one.name, "remove the obstacle, or allow more time or speed");
}

}  // namespace

bool has_arrived(double position, double target) {
  return std::abs(position - target) <= kArrived;
}

std::vector<double> present_targets(const Body& body) {
  const auto& servos = body.description().degrees_of_freedom;
  std::vector<double> targets = body.state().positions;
  for (std::size_t i = 0; i < servos.size(); ++i) {
    targets[i] = std::clamp(targets[i], servos[i].least, servos[i].most);
  }
  return targets;
}

Result<void> move_to(Body& body, std::span<const double> targets, const Motion& motion) {
  SOMATO_TRY_VOID(body.command(targets));
  std::size_t steps = 0;
  while (const auto servo = still_moving(body, targets)) {
    const double waited = static_cast<double>(steps++) * kStep;
    if (waited >= motion.longest) return never_arrived(body, *servo, targets[*servo], waited);
    SOMATO_TRY_VOID(body.step(kStep));
  }
  return body.step(motion.settle);
}

}  // namespace somato
