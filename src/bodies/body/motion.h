#pragma once

#include <span>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/bodies/explore_by.h"

namespace somato {

/// Whether a servo is at its target, within the precision of a driver's steps: 0.1 deg or mm.
bool has_arrived(double position, double target);

/// The current positions of the servos, as targets within their limits.
std::vector<double> present_targets(const Body& body);

/// Sends the servos to `targets`, advances until the driver has moved all of them there, and then
/// waits for rest. Errors: those of command() and step(); kData names a servo that did not arrive
/// in time.
Result<void> move_to(Body& body, std::span<const double> targets, const Motion& motion = {});

}  // namespace somato
