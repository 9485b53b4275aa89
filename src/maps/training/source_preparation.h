#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/process_group.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The result of one pass through the samples of a map, as it sees them.
struct SampleSurvey {
  std::size_t count = 0;    ///< Samples of all processes.
  std::size_t first = 0;    ///< Samples of the processes before this one.
  std::size_t parts = 0;    ///< Parts of this process.
  double longest = 0.0;     ///< Euclidean length of the longest sample.
  std::vector<float> low;   ///< The least value of each feature; empty without samples.
  std::vector<float> high;  ///< The greatest.
};

/// Surveys the samples of all `processes`, or with nullptr of this one. Fails as the source does.
Result<SampleSurvey> survey_samples(SampleSource& prepared, ProcessGroup* processes);

/// The map that batch training starts from, the same as from all samples in memory. `parameters`
/// are resolved, and `survey` is of the same samples and processes. Fails as the source does, and
/// as check_plane() does; kSystem if linear initial weights need all samples in memory, and these
/// do not fit. `threads` do not affect the map.
Result<Som> initial_som(const SomParameters& parameters, SampleSource& prepared,
                        const SampleSurvey& survey, ProcessGroup* processes,
                        std::size_t threads = 1);

}  // namespace somato
