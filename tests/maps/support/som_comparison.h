#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "maps/support/random_maps.h"
#include "maps/training/som_reference.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"
#include "somato/maps/som.h"

namespace somato::testing {

inline double length(std::span<const double> vector) {
  double sum = 0.0;
  const double* const values = vector.data();  // tests are not optimized: a span is slow to read
  const std::size_t size = vector.size();
  for (std::size_t d = 0; d < size; ++d) sum += values[d] * values[d];
  return std::sqrt(sum);
}

/// One neuron's weights within `tolerance` of the reference's, relative to their length.
inline void expect_row(const Som& som, const ReferenceSom& reference, std::size_t neuron,
                       double tolerance) {
  const auto expected = reference.weights().row(neuron);
  std::vector<double> difference(expected.begin(), expected.end());
  for (std::size_t d = 0; d < expected.size(); ++d) {
    difference[d] -= double{som.weight(neuron, d)};
  }
  EXPECT_LE(length(difference), tolerance * (length(expected) + 1e-30)) << "neuron " << neuron;
}

inline void expect_weights(const Som& som, const ReferenceSom& reference, double tolerance) {
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    expect_row(som, reference, neuron, tolerance);
  }
}

/// Whether the best two scores for this input are so close that rounding decides the winner.
inline bool ambiguous(const ReferenceSom& reference, std::span<const double> input,
                      std::size_t neurons) {
  double best = 1e300;
  double next = 1e300;
  const std::size_t winner = reference.winner(input);
  best = reference.score(input, winner);
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    if (neuron == winner) continue;
    const double score = reference.score(input, neuron);
    if (std::fabs(score - best) < std::fabs(next - best)) next = score;
  }
  return std::fabs(next - best) < 1e-5 * (1.0 + std::fabs(best));
}

inline Matrix<double> widened(Som som) {
  som.store_all();
  const Matrix<float> weights = som.weights().to_matrix();
  return {weights.rows(), weights.columns(), {weights.values().begin(), weights.values().end()}};
}

inline SomParameters random_resolved(Random& random, std::size_t samples, std::size_t size,
                                     const std::vector<Variant>& variants = all_variants()) {
  SomParameters p = random_parameters(variants[random.below(variants.size())], random);
  const auto shapes = shapes_that_attract();
  if (random.below(2) == 0) p.neighbourhood = shapes[random.below(shapes.size())];
  const auto& starts = Choices<InitialWeights>::all();
  p.initial_weights = starts[random.below(starts.size())].first;
  p.draws = random.below(2) == 0 ? Draws::kWithReplacement : Draws::kWithoutReplacement;
  p.arithmetic = Arithmetic::kPlain;
  return resolve(p, samples, size).value();
}

}  // namespace somato::testing
