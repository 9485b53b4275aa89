#pragma once

#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The weights of a map, for training; formed if necessary. The map then discards its inner
/// products with samples.
LaneMatrix<float>& weights_to_change(Som& som);

/// Scales every row to length 1; rows of zeros stay. `factors` is scratch memory.
void normalize_rows(LaneMatrix<float>& weights, AlignedVector<float>& factors);

/// Whether the map has weights for all elements that are not 0 in some sample.
bool has_weights_for(const Som& som, const Samples& samples);

}  // namespace somato
