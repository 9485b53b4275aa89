#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/core/signal.h"
#include "somato/maps/som_parameters.h"

namespace somato {

class ProductWeights;

/// The elements of an input for which a map stores weights: all, or those of a list. The weight of
/// any other element is 0.
class StoredElements {
 public:
  StoredElements() = default;

  /// All elements of an input of `size` elements.
  explicit StoredElements(std::size_t size) : size_(size) {}

  /// The elements in `listed`; throws InvalidArgument unless it is a possible_list().
  StoredElements(std::size_t size, std::vector<std::uint32_t> listed);

  /// The elements for which a sparse sample has a value, if they are fewer than half of all;
  /// otherwise all. The first element if there is no value.
  static StoredElements used_by(const Samples& samples);

  /// The elements in `used`, which is ascending, by the same rule.
  static StoredElements worth_storing(std::size_t size, std::vector<std::uint32_t> used);

  /// These elements and those for which `signal` has a value other than 0, by the same rule.
  StoredElements with(const SignalView& signal) const;

  /// Whether `listed` is not empty, is ascending without repeats and below `size`.
  static bool possible_list(std::size_t size, std::span<const std::uint32_t> listed);

  /// Number of elements of an input.
  std::size_t size() const { return size_; }

  /// Number of stored elements.
  std::size_t count() const { return all() ? size_ : listed_.size(); }

  bool all() const { return listed_.empty(); }

  /// Their numbers, ascending; empty when all are stored.
  std::span<const std::uint32_t> listed() const { return listed_; }

  /// The position of `element`, below size(), among the stored elements.
  std::optional<std::size_t> place_of(std::size_t element) const;

  /// Writes the stored elements of `signal`, times `factor`, to `out`, which has count() values.
  /// Returns the squared length of the others, times `factor` as well: above 0 if one of them is
  /// not 0. Throws InvalidArgument if a size differs.
  double gather(const SignalView& signal, std::span<float> out, double factor = 1.0) const;

  /// The sum of the magnitudes of the elements that are not stored, times `factor`.
  double magnitude_of_others(const SignalView& signal, double factor = 1.0) const;

  /// Converts samples of size() elements to samples of the stored elements; sparse samples become
  /// dense unless they are nearly empty. Throws InvalidArgument if the size differs.
  Samples gather(const Samples& samples) const;

  bool operator==(const StoredElements&) const = default;

 private:
  Signal dense_of(const SignalView& signal) const;
  Signal sparse_of(const SignalView& signal) const;

  std::size_t size_ = 0;
  std::vector<std::uint32_t> listed_;
};

/// Scratch memory for a Som: use one object per thread; prepared on first use.
class SomWorkspace {
 private:
  friend class DenseMap;
  friend class DirectMap;
  friend class Som;
  AlignedVector<float> input_;
  double left_out_ = 0.0;  // of elements without weights: squared length, or sum of magnitudes
  AlignedVector<float> scores_;
  std::vector<std::uint32_t> candidates_;
  std::vector<float> row_;
};

/// The two neurons most similar to an input.
struct Winners {
  std::size_t first = 0;
  std::size_t second = 0;  ///< Equal to `first` on a map with one neuron.
};

/// A self-organizing map. Its const functions can be used by several threads, each with a separate
/// workspace.
///
/// An input is a flat signal of input_size() elements; with `normalize_input` it is first scaled to
/// Euclidean length 1 (a zero input is unchanged), and with relevances its elements are then
/// multiplied by input_scales(). Different sizes throw InvalidArgument.
///
/// A map may store only the weights of some elements, if all others are 0: elements() lists them.
/// Its results are the same as with all weights.
///
/// A map trained by inner products forms its weights when they are first needed. It always keeps
/// the inner products with the samples that it was given.
class Som {
 public:
  Som() = default;

  /// A map with one row of `weights` per neuron. `parameters` must be resolved; throws
  /// InvalidArgument if the sizes of grid and weights differ.
  Som(SomParameters parameters, const Matrix<float>& weights);
  Som(SomParameters parameters, LaneMatrix<float> weights);

  /// A map with weights for `elements` of its inputs; also throws InvalidArgument unless there is
  /// one column of `weights` for each.
  Som(SomParameters parameters, LaneMatrix<float> weights, StoredElements elements);

  /// A map whose neurons are connected as `graph` says; throws InvalidArgument unless `parameters`
  /// has one row with a column for each neuron of the graph.
  Som(SomParameters parameters, const Matrix<float>& weights,
      std::shared_ptr<const NeuronGraph> graph);

  /// A map whose weights are formed when they are first needed; created by training.
  explicit Som(std::shared_ptr<const ProductWeights> products);

  const SomParameters& parameters() const { return parameters_; }
  const Grid& grid() const { return grid_; }
  std::size_t neurons() const { return grid_.size(); }
  std::size_t input_size() const { return elements_.size(); }

  /// The elements of an input that have weights.
  const StoredElements& elements() const { return elements_; }

  /// Neurons x elements().count(), as they are compared with inputs: times input_scales().
  const LaneMatrix<float>& weights() const { return products_ ? formed() : weights_; }

  /// The inner products of the map with samples, or nullptr.
  const std::shared_ptr<const ProductWeights>& products() const { return products_; }

  /// Whether the map has the inner products of these samples, or of the samples that they are a
  /// copy of.
  bool knows(const Samples& samples) const;

  /// The weight of `neuron` for `element` of an input, stored or not, in the unit of the input.
  float weight(std::size_t neuron, std::size_t element) const;

  /// Stores weights for all elements of an input; those without weights get 0.
  void store_all();

  /// Makes the distance of input x from weights w of a Euclidean map the root of the sum of r_i
  /// (x_i
  /// - w_i)^2, and that of a Manhattan map the sum of r_i |x_i - w_i|: `relevances` r has a finite
  /// number above 0 for each element of an input. Weights in the unit of the input, weight(), stay
  /// as they are up to rounding, and all are stored. Source: Hammer and Villmann, "Generalized
  /// relevance learning vector quantization", Neural Networks 15, 2002. Throws InvalidArgument for
  /// other numbers, another distance, or a map with layers.
  void set_relevances(std::vector<double> relevances);

  /// The factors by which a map with relevances multiplies an input, after normalization, and by
  /// which its stored weights() are multiplied: roots of the relevances for a Euclidean map, the
  /// relevances themselves for a Manhattan map. Empty without relevances.
  std::span<const float> input_scales() const { return input_scales_; }

  /// The same map, except that the weights of `neuron` are `input`, after normalization; those of a
  /// dot-product map have length 1. It also stores the elements for which the input has a value.
  /// Throws InvalidArgument if there is no such neuron or the size differs.
  Som with_neuron_at(std::size_t neuron, const SignalView& input) const;

  /// The neuron most similar to `input`, by distances or inner products in double precision (for
  /// cosine distances by (x . w) / |w|); in a tie the first neuron.
  std::size_t winner(const SignalView& input, SomWorkspace& workspace) const;

  /// The same for a dense input, with scratch memory of the thread.
  std::size_t winner(std::span<const float> input) const;

  /// The most similar neuron and the second most similar one.
  Winners winners(const SignalView& input, SomWorkspace& workspace) const;

  /// The most similar neuron among `candidates` (ascending, not empty).
  std::size_t winner_among(std::span<const std::size_t> candidates, const SignalView& input,
                           SomWorkspace& workspace) const;

  /// The same for samples[sample]. For samples that it knows(), the map uses inner products, in
  /// double precision and without weights: the same result up to rounding.
  Winners winners(const Samples& samples, std::size_t sample, SomWorkspace& workspace) const;
  std::size_t winner_among(std::span<const std::size_t> candidates, const Samples& samples,
                           std::size_t sample, SomWorkspace& workspace) const;
  double distance(const Samples& samples, std::size_t sample, std::size_t neuron,
                  SomWorkspace& workspace) const;

  /// The similarity of each neuron to `input`, higher values are more similar: w . x for a
  /// dot-product map; for the others 1 / (1 + d) with the map's distance d, which is in (0, 1] and
  /// decreases with distance for any scale of the data. `out` has neurons() values.
  void similarities(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const;

  /// The activity of each neuron: the softmax of the similarities s, rectified at 0, with the form,
  /// exponent and norm of the parameters (P11; an even power of a negative similarity would reverse
  /// the order). All zero if all similarities are zero.
  void activity(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const;

  /// The distance of the input, after normalization, from the weights of `neuron`, in double
  /// precision: that of the map's similarity, the Euclidean one for a dot-product map.
  double distance(const SignalView& input, std::size_t neuron, SomWorkspace& workspace) const;

 private:
  friend class DenseMap;
  friend class DirectMap;
  friend class ScoreSearch;
  friend class SparseLearner;
  friend class WinnerSearch;
  friend LaneMatrix<float>& weights_to_change(Som& som);
  const LaneMatrix<float>& formed() const;
  void store(StoredElements elements);
  double input_factor(const SignalView& input) const;
  std::span<const float> prepare(const SignalView& input, SomWorkspace& workspace) const;
  std::span<const float> scores(const SignalView& input, SomWorkspace& workspace) const;
  std::span<const float> scores_of(std::span<const float> prepared, SomWorkspace& workspace) const;
  void find_similarities(const SignalView& input, SomWorkspace& workspace) const;
  std::size_t winner_of(std::span<const float> prepared, SomWorkspace& workspace) const;
  Winners best_of(std::span<const float> prepared, bool two, SomWorkspace& workspace) const;
  Winners decide(std::span<const float> scores, std::span<const float> prepared, bool two,
                 SomWorkspace& workspace) const;
  double exact_score(std::span<const float> prepared, std::size_t neuron,
                     SomWorkspace& workspace) const;
  float score_margin(float best, std::span<const float> prepared) const;
  std::span<const float> ascending_scores_of(std::span<const float> prepared,
                                             SomWorkspace& workspace) const;

  SomParameters parameters_;
  Grid grid_;
  LaneMatrix<float> weights_;
  StoredElements elements_;
  std::vector<float> input_scales_;
  std::shared_ptr<const ProductWeights> products_;  // if true, weights_ is empty
};

/// Scales `values` to Euclidean length 1, with a sum of squares in double precision; zero vectors
/// are unchanged.
void normalize_length(std::span<float> values);

/// Multiplies each value by the scale of the same place (Som::input_scales()); without scales the
/// values stay.
void scale_elements(std::span<const float> scales, std::span<float> values);

}  // namespace somato
