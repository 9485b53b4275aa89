#pragma once

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

/// Online training on inner products; `parameters` resolved, `samples` prepared and of the stored
/// `elements` alone, as the map that is returned. See the source for the mathematics.
Result<Som> train_by_inner_products(const SomParameters& parameters, const Samples& samples,
                                    const StoredElements& elements, const TrainingOptions& options);

}  // namespace somato
