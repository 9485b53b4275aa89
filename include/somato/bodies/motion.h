#pragma once

#include <span>
#include <vector>

#include "somato/bodies/body.h"

namespace somato {

/// How long a body that is sent somewhere is waited for. Neither number is given in the papers.
struct Motion {
  double settle = 0.3;    ///< Seconds to come to rest after it has arrived; above 0.
  double longest = 20.0;  ///< Seconds until it must have arrived.
};

/// Whether a servo stands where it was sent, as far as a driver's steps can tell: within 0.1 deg or
/// mm.
bool has_arrived(double position, double target);

/// Where the servos have been driven to, as targets: within their limits.
std::vector<double> present_targets(const Body& body);

/// Sends the servos to `targets`, lets time pass until the driver has taken all of them there, and
/// then settles. Errors: those of command() and step(); kData names a servo that has not arrived in
/// time.
Result<void> move_to(Body& body, std::span<const double> targets, const Motion& motion = {});

}  // namespace somato
