#pragma once

#include <functional>

#include "somato/bodies/body.h"

namespace somato::detail {

/// Sends one servo to `target`; the others go on to where they are.
Result<void> drive_one(Body& body, std::size_t servo, double target);

/// Whether the driver considers it at the target, within a millionth of the servo's range.
bool has_arrived(const Body& body, std::size_t servo, double target);

/// Advances by `seconds` above 0 in equal steps of at most `step`, and calls `after_step` after
/// each.
Result<void> let_pass(Body& body, double seconds, double step,
                      Readings readings = Readings::kLeftOut,
                      const std::function<void()>& after_step = {});

/// The channel of a sensor without frames; it has as many columns as the sensor has elements, or
/// none if they are only known from its frames.
Channel empty_channel(const ChannelDescription& sensor);

}  // namespace somato::detail
