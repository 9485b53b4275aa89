#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/live/view_source.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// A look at a system that learns.
struct TrainingLook {
  std::string module;  ///< The map.
  std::uint64_t step = 0;
  std::uint64_t steps = 0;
  double radius = 0.0;
  double learning_rate = 0.0;
  std::vector<std::size_t> winners;  ///< Of the first samples; none while other modules learn.
  std::vector<std::string> classes;  ///< Of the same samples.
  std::vector<double> u_matrix;      ///< Or none.
  bool done = false;
};

/// Called now and then; when it returns false the training ends with an Error of kind kInterrupted.
using TrainingEyes = std::function<bool(const TrainingLook&)>;

/// Trains a system on all explorations of a recording and labels its map by majority, with looks at
/// the map while it learns: a hundred (of a map of more than four million weights 25, as each takes
/// its time), at the same steps whoever looks, so that what is learned
/// depends on the seed alone. (Each look settles the map, which changes roundings: `somato run`
/// gives the same map but for these.) A map that learns together with other modules, or in batches,
/// can be looked at when it is done only. `goes_on` is asked before each exploration is evaluated,
/// while there is nothing to look at; false ends the training too. Errors: kUsage and kData with
/// their place; kInterrupted.
Result<std::shared_ptr<const SystemModel>> train_visibly(const ViewSystem& system,
                                                         const Recording& recording,
                                                         std::uint64_t seed,
                                                         const TrainingEyes& eyes,
                                                         const std::function<bool()>& goes_on);

}  // namespace somato::live
