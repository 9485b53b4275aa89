#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/stored_elements.h"

namespace somato {

/// Scratch memory for using a Som: one object a thread, prepared by its first use.
class SomWorkspace {
 private:
  friend class Som;
  friend class SomLearner;
  AlignedVector<float> input_;
  double left_out_ = 0.0;  // squared length of the input's elements without weights
  AlignedVector<float> scores_;
  std::vector<std::uint32_t> candidates_;
  std::vector<float> row_;
};

/// The two neurons most similar to an input.
struct Winners {
  std::size_t first = 0;
  std::size_t second = 0;  ///< Equal to `first` on a map of one neuron.
};

/// A self-organizing map. It does not change while it is used, so threads can share it, each with
/// a workspace of its own.
///
/// An input is a flat signal of input_size() elements; with `normalize_input` it is scaled to
/// Euclidean length 1 first (a zero input stays zero). Sizes that differ throw InvalidArgument.
///
/// A map may keep the weights of some elements only, where all others are 0: elements() tells
/// which. It answers as if it had all of them.
class Som {
 public:
  Som() = default;

  /// A map with one row of `weights` a neuron. `parameters` must be resolved; throws
  /// InvalidArgument when the grid and the weights differ in size.
  Som(SomParameters parameters, const Matrix<float>& weights);
  Som(SomParameters parameters, LaneMatrix<float> weights);

  /// A map with weights for `elements` of its inputs; throws InvalidArgument also when there is not
  /// one column of `weights` for each.
  Som(SomParameters parameters, LaneMatrix<float> weights, StoredElements elements);

  const SomParameters& parameters() const { return parameters_; }
  const Grid& grid() const { return grid_; }
  std::size_t neurons() const { return grid_.size(); }
  std::size_t input_size() const { return elements_.size(); }

  /// The elements of an input that have weights.
  const StoredElements& elements() const { return elements_; }

  /// Neurons x elements().count().
  const LaneMatrix<float>& weights() const { return weights_; }
  LaneMatrix<float>& weights() { return weights_; }

  /// The weight of `neuron` for `element` of an input, stored or not.
  float weight(std::size_t neuron, std::size_t element) const;

  /// Gives all elements of an input weights, those that had none the weight 0.
  void store_all();

  /// The neuron most similar to `input`, by distances or inner products in double precision; the
  /// first one in the order of neurons in a tie.
  std::size_t winner(const SignalView& input, SomWorkspace& workspace) const;

  /// The most similar neuron and the next.
  Winners winners(const SignalView& input, SomWorkspace& workspace) const;

  /// The most similar of the neurons listed in `candidates` (ascending, not empty).
  std::size_t winner_among(std::span<const std::size_t> candidates, const SignalView& input,
                           SomWorkspace& workspace) const;

  /// The similarity of each neuron to `input`, greater being more similar: w . x for a dot-product
  /// map; for a Euclidean map 1 / (1 + |x - w|), which is in (0, 1] and falls with distance
  /// whatever the scale of the data. `out` holds neurons() values.
  void similarities(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const;

  /// The activity of each neuron: the softmax of the similarities s rectified at 0, in the form,
  /// with the exponent and the norm of the parameters (P11; an even power of a negative similarity
  /// would turn the order round). All zero when all similarities are.
  void activity(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const;

  /// The Euclidean distance of the input, as the map sees it, from the weights of `neuron`, in
  /// double precision.
  double distance(const SignalView& input, std::size_t neuron, SomWorkspace& workspace) const;

 private:
  friend class SomLearner;
  friend class WinnerSearch;
  double input_factor(const SignalView& input) const;
  std::span<const float> prepare(const SignalView& input, SomWorkspace& workspace) const;
  std::span<const float> scores(const SignalView& input, SomWorkspace& workspace) const;
  std::span<const float> scores_of(std::span<const float> prepared, SomWorkspace& workspace) const;
  std::size_t winner_of(std::span<const float> prepared, SomWorkspace& workspace) const;
  Winners best_of(std::span<const float> prepared, bool two, SomWorkspace& workspace) const;
  double exact_score(std::span<const float> prepared, std::size_t neuron,
                     SomWorkspace& workspace) const;
  float score_margin(float best, std::span<const float> prepared) const;
  std::span<const float> ascending_scores_of(std::span<const float> prepared,
                                             SomWorkspace& workspace) const;

  SomParameters parameters_;
  Grid grid_;
  LaneMatrix<float> weights_;
  StoredElements elements_;
};

/// Scales `values` to Euclidean length 1, by a sum of squares in double precision; zeros stay.
void normalize_length(std::span<float> values);

}  // namespace somato
