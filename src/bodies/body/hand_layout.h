#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/bodies/body.h"

namespace somato {

/// A segment of a finger: its servo, and its taxels.
struct Segment {
  std::size_t servo = 0;            ///< Index in the body's degrees of freedom.
  std::vector<std::size_t> taxels;  ///< Indices in the elements of its sensor `touch`.
};

struct Finger {
  std::string name;  ///< Such as "finger1".
  Segment proximal;
  Segment distal;
};

/// The servos and taxels of each finger of a body.
struct HandLayout {
  std::vector<Finger> fingers;
  std::size_t touch = 0;  ///< Index in the body's sensors.
};

/// The fingers of a body, identified by names: a servo `NAME_proximal` and a servo `NAME_distal`
/// form a finger, and the elements of the sensor `touch` named `NAME_proximal_...` and
/// `NAME_distal_...` are its taxels. Errors (kUsage): no finger, a finger without a distal servo, a
/// segment without taxels, no sensor `touch`.
Result<HandLayout> hand_layout(const BodyDescription& description);

}  // namespace somato
