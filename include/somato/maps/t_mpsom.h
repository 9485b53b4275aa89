#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom_arbor.h"
#include "somato/maps/t_mpsom_heard.h"
#include "somato/maps/t_mpsom_neighbourhood.h"
#include "somato/maps/t_mpsom_parameters.h"

namespace somato {

/// The Tensor Multiple Peak Self-Organizing Map for any number of inputs (P06 section 4.1, P07
/// section 2, P11 section II).
///
/// Neuron n has a weight vector w^a_n for each input a. With x^a the normalized input of K
/// elements, spread along an axis of I neurons, and u_n the place of neuron n on it (u and k count
/// from 1):
///
///     P^a_n = sum over k of A^a(u_n, k) w^a_nk x^a_k    A^a(u, k) = exp(-(u - k I/K)^2 / (2 s^2))
///     y_n   = product (multiplied) or sum (added) of P^a_n over the inputs a
///     N'_n  = sum over all neurons m of max(y_m, 0) G(|m - n|)            N_n = N'_n / max N'
///     w^a_n <- normalized(w^a_n + alpha N_n (x^a - w^a_n))
///
/// The papers print the update with a minus sign, which would drive weights away from the input.
/// Zeros and signs, which they leave open: a vector of zeros stays so when normalized; when no
/// neuron is active (max N' <= 0) nothing is learned; activity below zero, which only signed input
/// brings about, counts as none for N. Initial weights are uniform in [0, 1), then normalized.
/// Arbors, G along an axis, gains alpha N, updated weights and elements of inputs divided by their
/// length below 1e-18 are taken as zero, for speed. A neuron whose gain is zero keeps its weights,
/// once they are normalized.
///
/// While it is used the map is constant; each thread brings its own Workspace. Neurons are in
/// row-major order of the grid. Inputs must be finite; results have the same bits on every machine.
class TMpsom {
 public:
  /// Scratch memory of one thread for one map, and what the last call left in it.
  class Workspace {
   public:
    explicit Workspace(const TMpsom& map);

    /// y, one value a neuron, of the last activation() or learn().
    std::span<const double> activity() const { return activity_; }

    /// N, one value in 0 .. 1 a neuron, of the last learn(); all zero when nothing was learned.
    std::span<const double> neighbourhood() const { return neighbourhood_; }

   private:
    friend class TMpsom;
    friend class TMpsomLearner;

    std::vector<TMpsomHeard> inputs_;
    std::vector<float> sample_;
    AlignedVector<float> gains_;
    std::vector<double> activity_;
    std::vector<double> neighbourhood_;
    GridGaussian::Workspace spread_;
  };

  /// A map with initial weights; throws InvalidArgument with the message of validate() when the
  /// parameters are not valid.
  explicit TMpsom(TMpsomParameters parameters);

  /// A map with the given weights, one matrix of neurons x elements for each input, taken as they
  /// are. Errors: parameters that are not valid (kUsage); weights of another number or shape, or
  /// not finite (kData).
  static Result<TMpsom> from_weights(TMpsomParameters parameters,
                                     const std::vector<Matrix<float>>& weights);

  const TMpsomParameters& parameters() const { return parameters_; }
  std::size_t neurons() const { return parameters_.neurons(); }

  /// A copy of the weights of one input: neurons x elements.
  Matrix<float> weights(std::size_t input) const;

  /// A copy of the arbor A of one input: neurons x elements, each in 0 .. 1.
  Matrix<float> arbor(std::size_t input) const;

  /// Writes y, one value a neuron, to `out`. Only elements that are not zero cost anything, and
  /// sparse inputs give the same bits as dense ones. An input that is the same as in the last call
  /// with this workspace costs next to nothing, as long as the weights are the same, too. Does not
  /// allocate. Throws InvalidArgument when numbers or sizes differ from the parameters', or
  /// when something is not finite.
  void activation(std::span<const SignalView> inputs, Workspace& workspace,
                  std::span<float> out) const;

  /// One iteration: activity, N, update, normalization. `alpha` is in 0 .. 1. Returns whether
  /// anything was learned: not when no neuron is active. Does not allocate. Throws as activation().
  bool learn(std::span<const SignalView> inputs, double alpha, Workspace& workspace);

  /// The neuron with the greatest activity, the first of equals; throws InvalidArgument for none.
  static std::size_t winner(std::span<const float> activity);

  bool operator==(const TMpsom& other) const;

 private:
  friend class TMpsomLearner;

  struct Input {
    LaneMatrix<float> weights;
    TMpsomArbor arbor;
    bool normalized = false;  // for certain, if weights are to be
  };

  struct WithoutWeights {};
  TMpsom(TMpsomParameters parameters, WithoutWeights /*tag*/);

  void check(std::span<const SignalView> inputs, const Workspace& workspace) const;
  static std::uint64_t new_state();
  void take(std::span<const SignalView> inputs, Workspace& workspace) const;
  bool is_silent(const Workspace& workspace) const;
  void hear(std::span<const SignalView> inputs, Workspace& workspace) const;
  void combine(Workspace& workspace) const;
  void find_partial(const Input& input, TMpsomHeard& heard) const;
  bool find_gains(double alpha, Workspace& workspace) const;
  void move(Input& input, const TMpsomHeard& heard, Workspace& workspace) const;

  TMpsomParameters parameters_;
  std::vector<Input> inputs_;
  GridGaussian neighbourhood_;
  std::uint64_t state_;  // another number whenever weights change, so that none stands for two
};

}  // namespace somato
