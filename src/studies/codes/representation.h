#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "studies/codes/codes.h"
#include "studies/codes/views.h"

namespace somato {

/// The frames of a source in every view.
using ViewedFrames = PerView<Recording>;
ViewedFrames all_views_of(const Recording& frames);

/// A code with its scaling, and its vectors of all explorations.
struct Representation {
  Code code;
  Scaling scaling = Scaling::kNone;
  PerView<Samples> vectors;
};

/// The vectors of a code in the scalings; modules that learn are trained on whole explorations.
/// If every exploration has one frame, a view contains some elements of the vector instead.
/// Errors: those of the modules; vectors of more than `most_elements` (kData).
Result<std::vector<Representation>> represent(const ViewedFrames& frames, const Code& code,
                                              const std::vector<Scaling>& scalings,
                                              std::size_t most_elements, std::size_t threads);

}  // namespace somato
