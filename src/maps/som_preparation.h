#pragma once

#include <cstddef>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/stored_elements.h"

namespace somato {

/// What a map is trained on: parameters all decided; of the samples as the map sees them, the
/// elements for which it has weights.
struct PreparedTraining {
  SomParameters parameters;
  const Samples* samples = nullptr;
  StoredElements elements;
};

/// Gets `samples` ready to train a map on; the result refers to them or to `storage`. Fails as
/// train_som() does before it trains.
Result<PreparedTraining> prepare_training(const SomParameters& parameters, const Samples& samples,
                                          Samples& storage);

/// Refuses (kData) samples that there are none of, or without elements.
Result<void> check_samples(const Samples& samples);
Result<void> check_samples(std::size_t count, std::size_t size);

/// Refuses (kData) samples, as the map sees them, of a length outside 1e-15 .. 1e18.
Result<void> check_range(const Samples& prepared);
Result<void> check_range(double longest_squared);

/// Refuses (kSystem) a map with weights for so many elements that they do not fit into memory.
Result<void> check_memory(const SomParameters& parameters, std::size_t elements);

}  // namespace somato
