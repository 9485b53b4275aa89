#include "bodies/driving.h"

#include <cmath>

namespace somato::detail {

Result<void> drive_one(Body& body, std::size_t servo, double target) {
  std::vector<double> targets = body.state().positions;
  targets[servo] = target;
  return body.command(targets);
}

bool has_arrived(const Body& body, std::size_t servo, double target) {
  const DegreeOfFreedom& limits = body.description().degrees_of_freedom[servo];
  return std::abs(body.state().positions[servo] - target) <= 1e-6 * (limits.most - limits.least);
}

Result<void> let_pass(Body& body, double seconds, double step,
                      const std::function<void()>& after_step) {
  const double steps = std::ceil(seconds / step);
  for (double i = 0.0; i < steps; ++i) {
    if (auto stepped = body.step(seconds / steps); !stepped) return stepped;
    after_step();
  }
  return {};
}

Channel empty_channel(const ChannelDescription& sensor) {
  Channel channel;
  channel.name = sensor.name;
  channel.unit = sensor.unit;
  channel.element_names = sensor.element_names;
  channel.shape = sensor.shape;
  channel.rate = sensor.rate;
  return channel;
}

}  // namespace somato::detail
