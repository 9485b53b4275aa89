#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/recording/recording.h"
#include "somato/studies/information.h"

namespace somato {

/// How well the individuals' mean vectors follow the numbers of the label `asked.order`, within
/// each group of the label `asked.within`. `individuals` and `vectors` have one a sample. Errors as
/// measure_information() says of orders.
Result<OrderInformation> order_of_individuals(const Recording& recording,
                                              const InformationParameters& asked,
                                              const std::vector<std::size_t>& individuals,
                                              const Samples& vectors);

}  // namespace somato
