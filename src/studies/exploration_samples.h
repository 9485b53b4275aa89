#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/evaluation.h"
#include "somato/maps/known_samples.h"
#include "somato/recording/recording.h"

namespace somato {

/// The value of a label of each exploration; errors as find_label().
Result<std::vector<std::string>> labels_of(const Recording& recording, const std::string& name);

/// The same, equal values as equal numbers; every exploration has its own where `name` is empty.
Result<std::vector<std::size_t>> numbers_of(const Recording& recording, const std::string& name);

/// What a module of rate exploration gave for `explorations`, in that order; all must be known.
Samples single_values(const Activations& activations, std::size_t module,
                      const std::vector<std::size_t>& explorations);

/// What one module gave for explorations.
struct ExplorationValues {
  std::vector<std::size_t> explorations;  ///< Their numbers, ascending.
  KnownSamples samples;                   ///< One each.

  /// Where each of `wanted`, ascending and all there, stands among them.
  std::vector<std::size_t> places_of(const std::vector<std::size_t>& wanted) const;
};

/// The values of single_values(); `explorations` ascend.
ExplorationValues values_of(const Activations& activations, std::size_t module,
                            std::vector<std::size_t> explorations);

}  // namespace somato
