#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/recording/recording.h"
#include "somato/studies/information.h"

namespace somato {

/// The correlation of the individuals' mean vectors with the numbers of the label
/// `parameters.order`, within each group of the label `parameters.within`. `individuals` and
/// `vectors` have one per sample. Errors as measure_information() for orders.
Result<OrderInformation> order_of_individuals(const Recording& recording,
                                              const InformationParameters& parameters,
                                              const std::vector<std::size_t>& individuals,
                                              const Samples& vectors);

}  // namespace somato
