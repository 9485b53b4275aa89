#pragma once

#include <functional>

#include "somato/bodies/body.h"

namespace somato::detail {

/// Sends one servo to `target`; the others go on to where they are.
Result<void> drive_one(Body& body, std::size_t servo, double target);

/// Whether the driver believes it there, give or take a millionth of what the servo can do.
bool has_arrived(const Body& body, std::size_t servo, double target);

/// Lets `seconds` above 0 pass in equal steps of at most `step`, and calls `after_step` after each.
Result<void> let_pass(Body& body, double seconds, double step,
                      const std::function<Result<void>()>& after_step);

/// The channel of a sensor without frames; it has as many columns as the sensor has elements, or
/// none where only its frames tell.
Channel empty_channel(const ChannelDescription& sensor);

}  // namespace somato::detail
