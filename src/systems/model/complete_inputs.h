#pragma once

#include <cstddef>
#include <optional>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/som_model.h"
#include "somato/maps/som_training.h"
#include "systems/signals/missing_values.h"

namespace somato {

/// Whether missing values of data for the model's map can be treated in this way. Errors (kUsage):
/// the model has no means of its training data, or those of check_takes_incomplete().
Result<void> check_fills(const SomModel& model, MissingFill missing);

/// The samples, of which values may be missing (NaN) unless they are refused, as inputs of the
/// model's map. The model must pass check_fills().
Samples complete_inputs(const SomModel& model, MissingFill missing, const Samples& samples);

/// A weight of a map for `element` in the unit of the data that were standardized, or not.
double in_units(const std::optional<Standardization>& standardization, std::size_t element,
                float weight);

/// The map after training on dense samples in memory with missing values (NaN), which are left out:
/// TrainingOptions::incomplete, with initial weights as if they were the means of their columns.
/// Errors (kData): those of KnownValues; those of train_som().
Result<Som> train_leaving_out(const SomParameters& parameters, const Samples& samples,
                              TrainingOptions options);

}  // namespace somato
