#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// A direct implementation of the equations of a T-MPSOM, slow and in double precision: the
/// reference for tests of TMpsom, and an introduction to it. See TMpsom for the equations and their
/// sources.
class TMpsomReference {
 public:
  /// The initial weights of a TMpsom with the same parameters, in double precision; throws
  /// InvalidArgument if the parameters are not valid.
  explicit TMpsomReference(TMpsomParameters parameters);

  /// The given weights, one matrix of neurons x elements for each input, which are not normalized;
  /// throws InvalidArgument if they do not fit the parameters.
  TMpsomReference(TMpsomParameters parameters, std::vector<Matrix<double>> weights);

  const Matrix<double>& weights(std::size_t input) const { return weights_[input]; }

  /// A of one input for neuron `neuron` (counted from 0) and element `element` (counted from 0).
  double arbor(std::size_t input, std::size_t neuron, std::size_t element) const;

  /// y, one value per neuron, for dense inputs.
  std::vector<double> activation(const std::vector<std::vector<double>>& inputs) const;

  /// N of the activity y; all zero if no neuron is active.
  std::vector<double> neighbourhood(const std::vector<double>& activity) const;

  /// One iteration; returns whether anything was learned.
  bool learn(const std::vector<std::vector<double>>& inputs, double alpha);

 private:
  TMpsomParameters parameters_;
  std::vector<Matrix<double>> weights_;
};

}  // namespace somato
