#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/bodies/body.h"

namespace somato {

/// A segment of a finger: its servo, and the taxels on it.
struct Segment {
  std::size_t servo = 0;            ///< Among the body's degrees of freedom.
  std::vector<std::size_t> taxels;  ///< Among the elements of its sensor `touch`.
};

struct Finger {
  std::string name;  ///< Such as "finger1".
  Segment proximal;
  Segment distal;
};

/// Which servos and taxels of a body belong to which finger.
struct HandLayout {
  std::vector<Finger> fingers;
  std::size_t touch = 0;  ///< Among the body's sensors.
};

/// The fingers of a body, found by names: a servo `NAME_proximal` with a servo `NAME_distal` is a
/// finger, and the elements of the sensor `touch` called `NAME_proximal_...` and `NAME_distal_...`
/// are its taxels. Errors (kUsage): no finger, a finger without a distal servo, a segment without
/// taxels, no sensor `touch`.
Result<HandLayout> hand_layout(const BodyDescription& description);

}  // namespace somato
