#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/som_training.h"

namespace somato {

/// The start of training, in the arithmetic that its parameters and samples require.
struct SomStart {
  Som som;          ///< Before any learning; by plain arithmetic with the stored elements only.
  Samples samples;  ///< As this map takes them.
  std::vector<std::size_t> training;  ///< Their numbers that it learns from.
  StoredElements elements;            ///< The elements of whole inputs.

  /// `trained` as a map of whole inputs.
  Som whole(Som trained) const;
};

/// Fails as train_som() does before it trains.
Result<SomStart> start_som(const SomParameters& parameters, const Samples& samples,
                           const TrainingOptions& options);

}  // namespace somato
