#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/random.h"
#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// Chooses up to `count` of the samples with the numbers `candidates`: their numbers, ascending.
std::vector<std::size_t> choose_samples(ReplayChoice choice, std::size_t count,
                                        const Samples& samples,
                                        const std::vector<std::size_t>& candidates, Random& random);

/// `count` vectors for a class of a map, a row each, around the weights of neurons that its labels
/// give to the class. A neuron is drawn in proportion to its votes for the class. Each element
/// gets normal noise of the standard deviation spread d / sqrt(elements), where d is the distance
/// of the neuron from the nearest other one. No rows if no neuron has the class.
Matrix<float> generated_vectors(std::size_t count, double spread, const Som& som,
                                const NeuronVotes& votes, std::size_t the_class, Random& random);

}  // namespace somato
