#pragma once

#include <cstddef>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The input of a map's training: parameters all decided; of the samples as the map sees them, the
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

/// The same for the length of the longest of them, which longest_of() finds.
Result<void> check_longest(double longest);
double longest_of(const Samples& prepared);

/// Whether online training can make weights grow without limit: with negative factors of the
/// neighbourhood, except for a dot-product map, whose weights have length 1.
bool may_diverge(const SomParameters& parameters);

/// Refuses (kData) a map with weights beyond 1e18, which such training leads to.
Result<void> check_bounded(const Som& som);

/// The bytes that training a map with weights for so many elements takes, beside the samples.
double training_memory(const SomParameters& parameters, std::size_t elements);

/// Refuses (kSystem) a map with weights for so many elements that training it does not fit into
/// memory.
Result<void> check_memory(const SomParameters& parameters, std::size_t elements);

}  // namespace somato
