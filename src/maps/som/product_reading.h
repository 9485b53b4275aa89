#pragma once

#include <cstddef>
#include <span>

#include "somato/core/check.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The evaluation of a map for one input, for any representation of its weights: all results follow
/// from the products of the input with the weights and from squared lengths, in double precision.
/// In a tie the first neuron wins.
struct ProductReading {
  Similarity similarity = Similarity::kEuclidean;
  std::span<const double> products;         ///< One per neuron: of the input with its weights.
  std::span<const double> squared_lengths;  ///< One per neuron: of its weights.
  double squared_input = 0.0;               ///< The squared length of the input.
  double scale = 1.0;                       ///< A factor of the input that `products` leave out.
};

/// The less, the more similar: the squared distance without the input's own length, or the negative
/// inner product.
inline double score(const ProductReading& reading, std::size_t neuron) {
  const double product = reading.scale * reading.products[neuron];
  return reading.similarity == Similarity::kDotProduct
             ? -product
             : reading.squared_lengths[neuron] - 2.0 * product;
}

/// Like the functions of Som with these names.
Winners winners(const ProductReading& reading);
std::size_t winner_among(std::span<const std::size_t> candidates, const ProductReading& reading);
double distance(const ProductReading& reading, std::size_t neuron);
void similarities(const ProductReading& reading, std::span<float> out);
void activity(const ProductReading& reading, const SomParameters& parameters, std::span<float> out);

/// The two lowest scores, the earlier neuron first in a tie.
class BestTwo {
 public:
  void meet(double score, std::size_t neuron) {
    if (met_ == 0 || score < first_) {
      second_ = first_;
      winners_ = {neuron, met_ == 0 ? neuron : winners_.first};
      first_ = score;
    } else if (met_ == 1 || score < second_) {
      second_ = score;
      winners_.second = neuron;
    }
    ++met_;
  }
  const Winners& winners() const { return winners_; }

 private:
  std::size_t met_ = 0;
  double first_ = 0.0;
  double second_ = 0.0;
  Winners winners_;
};

/// The candidate with the least `score_of` it. Throws InvalidArgument without candidates, and for
/// one that is not below `neurons`.
template <typename Score>
std::size_t best_among(std::span<const std::size_t> candidates, std::size_t neurons,
                       const Score& score_of) {
  require(!candidates.empty(), "winner_among needs at least one candidate");
  BestTwo best;
  for (const std::size_t neuron : candidates) {
    require(neuron < neurons, "winner_among: a neuron does not exist");
    best.meet(score_of(neuron), neuron);
  }
  return best.winners().first;
}

}  // namespace somato
