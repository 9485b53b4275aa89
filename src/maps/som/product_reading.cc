#include "maps/som/product_reading.h"

#include <algorithm>
#include <cmath>

#include "maps/grid/activity.h"

namespace somato {
namespace {

// Rounding may leave a difference of equals below 0.
double squared_distance(const ProductReading& reading, std::size_t neuron) {
  const double product = reading.scale * reading.products[neuron];
  return std::max(0.0, reading.squared_input + (reading.squared_lengths[neuron] - 2.0 * product));
}

}  // namespace

Winners winners(const ProductReading& reading) {
  BestTwo best;
  for (std::size_t neuron = 0; neuron < reading.products.size(); ++neuron) {
    best.meet(score(reading, neuron), neuron);
  }
  return best.winners();
}

std::size_t winner_among(std::span<const std::size_t> candidates, const ProductReading& reading) {
  return best_among(candidates, reading.products.size(),
                    [&](std::size_t neuron) { return score(reading, neuron); });
}

double distance(const ProductReading& reading, std::size_t neuron) {
  require(neuron < reading.products.size(), "a neuron does not exist");
  return std::sqrt(squared_distance(reading, neuron));
}

void similarities(const ProductReading& reading, std::span<float> out) {
  require(out.size() == reading.products.size(),
          "similarities need space for one value per neuron");
  const bool dot_product = reading.similarity == Similarity::kDotProduct;
  for (std::size_t neuron = 0; neuron < out.size(); ++neuron) {
    out[neuron] = dot_product ? static_cast<float>(reading.scale * reading.products[neuron])
                              : similarity_at(squared_distance(reading, neuron));
  }
}

void activity(const ProductReading& reading, const SomParameters& parameters,
              std::span<float> out) {
  similarities(reading, out);
  activity_of_similarities(parameters, out);
}

}  // namespace somato
