#pragma once

#include <cstddef>
#include <span>

#include "maps/product_problem.h"

namespace somato {

/// The squared distance of weights from a known sample, by their inner product and the weights' own
/// squared length; at least 0.
double product_distance(const ProductProblem& problem, std::size_t sample, double product,
                        double squared_length);

/// As Som::similarities(), from values for each neuron.
void product_similarities(const ProductProblem& problem, std::size_t sample,
                          std::span<const double> products, std::span<const double> squared_lengths,
                          std::span<float> out);

}  // namespace somato
