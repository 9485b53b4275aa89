#pragma once

#include <cstddef>

#include "somato/maps/som.h"

namespace somato {

/// The measure SomMeasure::kTopographicProduct. Neurons at equal distances are in the order of
/// their numbers.
double topographic_product(const Som& som, std::size_t threads);

}  // namespace somato
