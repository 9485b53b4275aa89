#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// The frames of a source, such as a line of sensors, that a body gives in a step.
enum class KeptFrames {
  kLatest,  ///< One, the latest at the end of the step.
  kEvery,   ///< Each one, with its time.
};

template <>
struct Choices<KeptFrames> {
  static const std::vector<std::pair<KeptFrames, std::string>>& all();
};

}  // namespace somato
