#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/maps/schedule.h"

namespace somato {

class GridGaussian;
class TMpsomReceptiveInput;

/// Operation that combines the partial activations of a neuron, one per input, to its activity.
enum class TMpsomCombination {
  kMultiplied,  ///< Their product (P06 model 3, P07 and P11 model 2).
  kAdded,       ///< Their sum (P07 and P11 model 3).
};

template <>
struct Choices<TMpsomCombination> {
  static const std::vector<std::pair<TMpsomCombination, std::string>>& all();
};

/// Divisor of a vector before it is used.
enum class TMpsomNorm {
  kL2,    ///< Its Euclidean length; a zero vector is unchanged.
  kNone,  ///< Nothing.
};

template <>
struct Choices<TMpsomNorm> {
  static const std::vector<std::pair<TMpsomNorm, std::string>>& all();
};

/// The parameters of a T-MPSOM with any number of inputs.
///
/// Neurons form a rectangular grid with any number of axes. Every input is distributed along one of
/// them: each neuron receives the part of the input that corresponds to its position on that axis.
/// The papers have two inputs on two axes. Additional inputs may have separate axes (a grid with
/// more axes), or share axes (`input_axes` names an axis more than once); every axis needs at least
/// one input.
struct TMpsomParameters {
  std::vector<std::size_t> shape;
  std::vector<std::size_t> input_sizes;
  std::vector<std::size_t> input_axes;
  TMpsomCombination combination = TMpsomCombination::kMultiplied;
  double arbor_sigma = 1.0;
  double neighbourhood_sigma = 1.0;
  ScheduleShape learning_rate_schedule = ScheduleShape::kLinear;
  double learning_rate_start = 0.1;
  double learning_rate_end = 0.0;
  std::optional<std::uint64_t> learning_rate_reached_at;
  TMpsomNorm input_norm = TMpsomNorm::kL2;
  TMpsomNorm weight_norm = TMpsomNorm::kL2;
  std::uint64_t iterations = 5000;
  std::uint64_t seed = 1;

  static const Declarations<TMpsomParameters>& declarations();

  /// Whether shape, inputs, axes and rates are consistent and every number is in its declared
  /// range; errors (kUsage) name the parameters.
  Result<void> validate() const;

  /// alpha(t) over the iterations, counted from 0. P06 and P11 require 0 <= alpha(t) <= 1 and
  /// alpha(t) -> 0; the values are not given in the paper.
  Schedule learning_rate() const {
    return {learning_rate_schedule, learning_rate_start, learning_rate_end,
            learning_rate_reached_at.value_or(iterations)};
  }

  /// The axis of each input, with the default resolved.
  std::vector<std::size_t> axes() const;

  /// The number of neurons: the product of `shape`, which must be valid.
  std::size_t neurons() const;

  /// The position along `axis`, counted from 0, of neuron `neuron` in row-major order.
  std::size_t place(std::size_t neuron, std::size_t axis) const;

  bool operator==(const TMpsomParameters&) const = default;
};

/// The Tensor Multiple Peak Self-Organizing Map for any number of inputs (P06 section 4.1, P07
/// section 2, P11 section II).
///
/// Neuron n has a weight vector w^a_n for each input a. With x^a the normalized input of K
/// elements, distributed along an axis of I neurons, and u_n the position of neuron n on it (u and
/// k count from 1):
///
///     P^a_n = sum over k of A^a(u_n, k) w^a_nk x^a_k    A^a(u, k) = exp(-(u - k I/K)^2 / (2 s^2))
///     y_n   = product (multiplied) or sum (added) of P^a_n over the inputs a
///     N'_n  = sum over all neurons m of max(y_m, 0) G(|m - n|)            N_n = N'_n / max N'
///     w^a_n <- normalized(w^a_n + alpha N_n (x^a - w^a_n))
///
/// The papers print the update with a minus sign, which would move weights away from the input. The
/// papers do not specify the treatment of zeros and signs; here, a zero vector is unchanged by
/// normalization; if no neuron is active (max N' <= 0), nothing is learned; negative activity,
/// which only occurs with signed input, is treated as 0 in N. Initial weights are uniform in [0,
/// 1), then normalized. Arbors, G along an axis, gains alpha N, updated weights and elements of
/// inputs divided by their length below 1e-18 are treated as zero, for speed. A neuron whose gain
/// is zero keeps its weights, once they are normalized.
///
/// Const functions can be used by several threads, each with a separate Workspace. Neurons are in
/// row-major order of the grid. Inputs must be finite; results have the same bits on every machine.
class TMpsom {
 public:
  /// Scratch memory of one thread for one map, and the results of the last call.
  class Workspace {
   public:
    explicit Workspace(const TMpsom& map);
    Workspace(const Workspace& other);
    Workspace(Workspace&& other) noexcept;
    Workspace& operator=(const Workspace& other);
    Workspace& operator=(Workspace&& other) noexcept;
    ~Workspace();

    /// y, one value per neuron, of the last activation() or learn().
    std::span<const double> activity() const { return activity_; }

    /// N, one value in 0 .. 1 per neuron, of the last learn(); all zero if nothing was learned.
    std::span<const double> neighbourhood() const { return neighbourhood_; }

   private:
    friend class TMpsom;
    friend class TMpsomLearner;

    std::vector<TMpsomReceptiveInput> inputs_;
    std::vector<float> sample_;
    AlignedVector<float> gains_;
    std::vector<double> activity_;
    std::vector<double> neighbourhood_;
    AlignedVector<double> spread_;
  };

  /// A map with initial weights; throws InvalidArgument with the message of validate() if the
  /// parameters are not valid.
  explicit TMpsom(TMpsomParameters parameters);

  TMpsom(const TMpsom& other);
  TMpsom(TMpsom&& other) noexcept;
  TMpsom& operator=(const TMpsom& other);
  TMpsom& operator=(TMpsom&& other) noexcept;
  ~TMpsom();

  /// A map with the given weights, one matrix of neurons x elements for each input, which are not
  /// normalized. Errors: parameters that are not valid (kUsage); weights of the wrong number or
  /// shape, or not finite (kData).
  static Result<TMpsom> from_weights(TMpsomParameters parameters,
                                     const std::vector<Matrix<float>>& weights);

  const TMpsomParameters& parameters() const { return parameters_; }
  std::size_t neurons() const { return parameters_.neurons(); }

  /// A copy of the weights of one input: neurons x elements.
  Matrix<float> weights(std::size_t input) const;

  /// A copy of the arbor A of one input: neurons x elements, each in 0 .. 1.
  Matrix<float> arbor(std::size_t input) const;

  /// Writes y, one value per neuron, to `out`. The computing time depends only on the non-zero
  /// elements, and sparse inputs give the same bits as dense ones. An input that equals that of the
  /// last call with this workspace has almost no cost, if the weights are unchanged as well. Does
  /// not allocate. Throws InvalidArgument if numbers or sizes differ from the parameters', or if a
  /// value is not finite.
  void activation(std::span<const SignalView> inputs, Workspace& workspace,
                  std::span<float> out) const;

  /// One iteration: activity, N, update, normalization. `alpha` is in 0 .. 1. Returns whether
  /// anything was learned, which is not the case if no neuron is active. Does not allocate. Throws
  /// like activation().
  bool learn(std::span<const SignalView> inputs, double alpha, Workspace& workspace);

  /// The neuron with the greatest activity, the first in a tie; throws InvalidArgument for an empty
  /// list.
  static std::size_t winner(std::span<const float> activity);

  bool operator==(const TMpsom& other) const;

 private:
  friend class TMpsomLearner;

  struct Input;

  struct WithoutWeights {};
  TMpsom(TMpsomParameters parameters, WithoutWeights /*tag*/);

  void check(std::span<const SignalView> inputs, const Workspace& workspace) const;
  static std::uint64_t new_state();
  void take(std::span<const SignalView> inputs, Workspace& workspace) const;
  bool is_silent(const Workspace& workspace) const;
  void find_activity(std::span<const SignalView> inputs, Workspace& workspace) const;
  void combine(Workspace& workspace) const;
  void find_partial(const Input& input, TMpsomReceptiveInput& receptive) const;
  bool find_gains(double alpha, Workspace& workspace) const;
  void move(Input& input, const TMpsomReceptiveInput& receptive, Workspace& workspace) const;

  TMpsomParameters parameters_;
  std::vector<Input> inputs_;
  std::shared_ptr<const GridGaussian> neighbourhood_;  // which copies share
  std::uint64_t state_;  // changes with the weights, so that each number identifies one state
};

}  // namespace somato
