#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// A direct implementation of the equations of a SOM in double precision, simple and slow: the
/// reference for tests of the fast map.
///
/// Initial weights and draws are those of the fast map.
class ReferenceSom {
 public:
  /// `parameters` must be resolved.
  ReferenceSom(SomParameters parameters, Matrix<double> weights);

  /// The initial map of train_som().
  static ReferenceSom initial(const SomParameters& parameters, const Samples& samples);

  /// The map after the complete training with `parameters` on `samples`.
  static ReferenceSom trained(const SomParameters& parameters, const Samples& samples);

  const Matrix<double>& weights() const { return weights_; }

  /// The quantity that determines the winner: the squared Euclidean distance or another distance
  /// (minimum), or the inner product (maximum).
  double score(std::span<const double> input, std::size_t neuron) const;

  std::size_t winner(std::span<const double> input) const;
  double neighbourhood(std::size_t winner, std::size_t neuron, double radius) const;
  double distance(std::span<const double> input, std::size_t neuron) const;
  std::vector<double> activity(std::span<const double> input) const;

  /// One iteration: w += learning_rate h (input - w), followed by scaling to length 1 for a
  /// dot-product map.
  void learn(std::span<const double> input, double learning_rate, double radius);

  /// The same with a given winner: where two neurons are equally near, rounding decides which wins.
  void learn_at(std::size_t winner, std::span<const double> input, double learning_rate,
                double radius);

  /// One epoch: each weight becomes the weighted mean of the inputs.
  void learn_batch(const std::vector<std::vector<double>>& inputs, double radius);

  /// The samples after normalization, in double precision.
  std::vector<std::vector<double>> inputs(const Samples& samples) const;

 private:
  void normalize_weights();

  SomParameters parameters_;
  Grid grid_;
  Matrix<double> weights_;
};

}  // namespace somato
