#pragma once

#include <span>

#include "somato/maps/som_parameters.h"

namespace somato {

/// The similarity of a Euclidean map at that squared distance; see Som::similarities().
float similarity_at(double squared_distance);

/// Turns the similarities of the neurons into their activity; see Som::activity().
void activity_of_similarities(const SomParameters& parameters, std::span<float> values);

}  // namespace somato
