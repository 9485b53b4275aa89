#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/recording/recording.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// One vector an exploration, with the name of each element (`channel.element`, such as
/// `joints.thumb_distal`).
struct Vectors {
  Samples samples;
  std::vector<std::string> element_names;
};

/// The vectors of all explorations, not standardized. `recording` must be valid. Errors: an unknown
/// channel (kUsage, with the nearest known one).
Result<Vectors> make_vectors(const Recording& recording, const VectorParameters& parameters);

}  // namespace somato
