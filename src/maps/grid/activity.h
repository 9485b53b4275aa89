#pragma once

#include <cstddef>
#include <span>

#include "somato/core/matrix.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The similarity of a Euclidean map at that squared distance; see Som::similarities().
float similarity_at(double squared_distance);

/// Turns squared distances, plus `left_out` each, into similarities, bit by bit those of
/// similarity_at(). There are whole cache lines of values.
void similarities_of_squares(AlignedVector<float>& values, double left_out);

/// Turns the similarities of the neurons into their activity; see Som::activity().
void activity_of_similarities(const SomParameters& parameters, std::span<float> values);

/// The same for the first `count` of whole cache lines of values.
void activity_of_similarities(const SomParameters& parameters, AlignedVector<float>& values,
                              std::size_t count);

}  // namespace somato
