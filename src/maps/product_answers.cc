#include "maps/product_answers.h"

#include <algorithm>

#include "maps/activity.h"

namespace somato {

// Rounding may leave a difference of equals below 0.
double product_distance(const ProductProblem& problem, std::size_t sample, double product,
                        double squared_length) {
  const double of_sample = problem.known().products()(sample, sample);
  return std::max(0.0, of_sample + (squared_length - 2.0 * product));
}

void product_similarities(const ProductProblem& problem, std::size_t sample,
                          std::span<const double> products, std::span<const double> squared_lengths,
                          std::span<float> out) {
  const bool dot_product = problem.parameters().similarity == Similarity::kDotProduct;
  for (std::size_t neuron = 0; neuron < out.size(); ++neuron) {
    out[neuron] = dot_product ? static_cast<float>(products[neuron])
                              : similarity_at(product_distance(problem, sample, products[neuron],
                                                               squared_lengths[neuron]));
  }
}

}  // namespace somato
