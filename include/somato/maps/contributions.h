#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"

namespace somato {

/// The two neurons whose comparison decides the class of a sample.
struct DecidingNeurons {
  std::size_t nearest = 0;  ///< The most similar neuron with a label, whose class is the answer.
  std::size_t other = 0;    ///< The most similar neuron of all other classes.
};

/// The elements of an input that separate two neurons. An element with a positive contribution
/// makes the input more similar to the first neuron, one with a negative contribution to the other.
struct Contributions {
  double of_nearest = 0.0;  ///< Its distance from the input; for a dot-product map w . x.
  double of_other = 0.0;    ///< That of the other neuron.

  /// One for each element of Som::elements(), in its order; all other elements contribute nothing.
  /// They sum to `of_other - of_nearest`, for a dot-product map to `of_nearest - of_other`, up to
  /// rounding.
  std::vector<double> values;
};

/// The neurons that decide, for each sample; as NeuronLabels::classify(), for any number of
/// threads. Throws InvalidArgument if fewer than two classes have a neuron, or the sizes differ.
std::vector<DecidingNeurons> deciding_neurons(const Som& som, const NeuronLabels& labels,
                                              const Samples& samples, std::size_t threads = 1);

/// The contributions of the elements of `input` x to the difference of the distances d(x, b) of
/// `other` and d(x, a) of `nearest`, after normalization. Element i contributes
///
/// - Euclidean: ((x_i - b_i)^2 - (x_i - a_i)^2) / (d(x, a) + d(x, b)), or 0 if both distances are;
/// - Manhattan: |x_i - b_i| - |x_i - a_i|;
/// - cosine: x_i (a_i / |a| - b_i / |b|) / |x|, without a quotient of zeros;
/// - dot product: x_i (a_i - b_i);
/// - Chebyshev: d(x, b) where |x_i - b_i| is the greatest difference, minus d(x, a) where |x_i -
///   a_i| is; of n equal ones each has the n-th part. All others contribute 0;
/// - relevances: the same of x, a and b times Som::input_scales();
/// - layers: the contribution to the layer's distance, times its weight and divided by its scale.
///
/// Elements that are missing (NaN) contribute 0 and are left out of distances and lengths. The
/// result is not defined by a paper. Throws InvalidArgument if a neuron is not on the map or the
/// size differs.
Contributions contributions(const Som& som, const SignalView& input, DecidingNeurons neurons);

}  // namespace somato
