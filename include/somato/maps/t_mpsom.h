#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"
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
/// Arbors, G along an axis, gains alpha N and updated weights below 1e-18 are taken as zero, for
/// speed.
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

    // What came in last for one input, and the partial activations that it gave.
    struct Heard {
      Heard(std::size_t elements, std::size_t padded_neurons);
      bool is_again(const SignalView& signal) const;
      void take(const SignalView& signal, TMpsomNorm norm);
      void write_dense(std::span<float> out) const;

      std::size_t count = 0;  // of elements that are not zero: the others add nothing
      std::vector<std::uint32_t> indices;
      std::vector<float> values;  // as they came
      std::vector<float> normalized;
      std::vector<std::uint32_t> ranks;  // how many of `indices` are below each element
      AlignedVector<float> partial;
      std::uint64_t state = 0;  // of the weights that `partial` is of; 0: it is of none
    };

    std::vector<Heard> inputs_;
    std::vector<float> sample_;
    AlignedVector<float> gains_;
    AlignedVector<float> squared_norms_;
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
  // The elements that a group of neurons sees: beyond, their arbors are zero.
  struct ReceptiveField {
    void widen(const LaneMatrix<float>& arbor, std::size_t neuron);

    std::size_t first = 0;
    std::size_t end = 0;
  };

  struct Input {
    Input(const TMpsomParameters& parameters, std::size_t input);

    LaneMatrix<float> weights;
    LaneMatrix<float> arbor;
    std::vector<ReceptiveField> fields;  // of each kGroup blocks
  };

  struct WithoutWeights {};
  TMpsom(TMpsomParameters parameters, WithoutWeights /*tag*/);

  void check(std::span<const SignalView> inputs, const Workspace& workspace) const;
  void hear(std::span<const SignalView> inputs, Workspace& workspace) const;
  void find_partial(std::size_t input, Workspace::Heard& heard) const;
  void combine(std::size_t input, Workspace& workspace) const;
  bool find_gains(double alpha, Workspace& workspace) const;
  void move(Input& input, Workspace& workspace) const;
  void normalize_all(Input& input, Workspace& workspace);
  static void normalize_blocks(Input& input, std::size_t first, std::size_t count,
                               float* squared_norms);

  TMpsomParameters parameters_;
  std::vector<Input> inputs_;
  GridGaussian neighbourhood_;
  std::uint64_t state_;  // another number whenever weights change, so that none stands for two
};

}  // namespace somato
