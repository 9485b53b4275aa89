#include "bodies/body/driving.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

#include "bodies/body/motion.h"

namespace somato::detail {
namespace {

// 0 if it is only known from its frames.
std::size_t elements_of(const ChannelDescription& sensor) {
  if (!sensor.element_names.empty() || sensor.shape.empty()) return sensor.element_names.size();
  return std::accumulate(sensor.shape.begin(), sensor.shape.end(), std::size_t{1},
                         std::multiplies<>());
}

}  // namespace

Result<void> drive_one(Body& body, std::size_t servo, double target) {
  std::vector<double> targets = present_targets(body);
  targets[servo] = target;
  return body.command(targets);
}

bool has_arrived(const Body& body, std::size_t servo, double target) {
  const DegreeOfFreedom& limits = body.description().degrees_of_freedom[servo];
  return std::abs(body.state().positions[servo] - target) <= 1e-6 * (limits.most - limits.least);
}

Result<void> let_pass(Body& body, double seconds, double step, Readings readings,
                      const std::function<void()>& after_step) {
  const auto steps = std::llround(std::ceil(seconds / step));
  for (std::int64_t i = 0; i < steps; ++i) {
    auto stepped = body.step(seconds / static_cast<double>(steps), readings);
    if (!stepped) return stepped;
    if (after_step) after_step();
  }
  return {};
}

Channel empty_channel(const ChannelDescription& sensor) {
  return channel_of(sensor, Matrix<float>(0, elements_of(sensor)));
}

}  // namespace somato::detail
