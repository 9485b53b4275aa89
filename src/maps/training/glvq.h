#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "maps/reading/known_elements.h"
#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The settings of a step of GLVQ.
struct GlvqStep {
  double learning_rate = 0.0;   ///< 0 to 0.5: no neuron then moves beyond the sample.
  double steepness = 0.0;       ///< That of the sigmoid, above 0.
  double relevance_rate = 0.0;  ///< By how much relevances change, at least 0.
};

/// The classes that neurons begin with.
struct NeuronClasses {
  std::vector<std::size_t> of_neuron;
  std::size_t named_by_nearest = 0;  ///< Neurons that won no sample.
};

/// Each neuron's class by the classes of samples, of which there must be one: by majority, in a tie
/// the lowest number; for a neuron that wins none, that of the nearest sample in single precision,
/// the first in a tie. The samples are as the map sees them.
NeuronClasses classes_of_neurons(const Som& som, const Samples& seen,
                                 const std::vector<std::size_t>& classes);

/// Learns one labelled sample after the other by GLVQ, and relevances by GRLVQ. Refers to the map,
/// whose weights and relevances change, and which must be Euclidean or Manhattan without layers.
class Glvq {
 public:
  /// `class_of_neuron` has a class for each neuron; adjacent neurons learn the share `neighbours`.
  /// Relevances of elements that are not among `varying` stay 1, and do not count in their mean.
  Glvq(Som& som, std::vector<std::size_t> class_of_neuron, double neighbours,
       std::vector<bool> varying = {});

  /// Whether samples of this class can be learned: a neuron has it, and another one does not.
  bool has_both_sides(std::size_t the_class) const;

  /// Learns a sample as the map sees it, of which elements may be missing (NaN). Nothing changes
  /// unless has_both_sides(), or if both neurons are where the sample is.
  void learn(std::span<const float> sample, std::size_t its_class, const GlvqStep& step);

  /// Changes the relevances of the map by the steps of all samples that were learned since the last
  /// call with a `relevance_rate`. The mean of those that differ in samples is then 1, unless one
  /// would be below 1e-6; the others are 1.
  void update_relevances();

 private:
  // The neurons nearest to a sample, of its class and of another one.
  struct Pair {
    std::size_t right = 0;
    std::size_t wrong = 0;
    double to_right = 0.0;
    double to_wrong = 0.0;
  };

  std::size_t nearest(const KnownScores& known, std::size_t the_class, bool of_class);
  double distance(const KnownScores& known, std::size_t neuron);
  void move(std::span<const float> sample, const std::vector<KnownRun>& runs, std::size_t neuron,
            double gain);
  void add_relevance_steps(std::span<const float> sample, const std::vector<KnownRun>& runs,
                           const Pair& pair, double rate);

  Som& som_;
  LaneMatrix<float>& weights_;
  std::vector<std::size_t> class_of_neuron_;
  std::vector<std::size_t> neurons_of_class_;
  double neighbours_;
  std::vector<bool> varying_;
  std::size_t varying_count_ = 0;
  std::vector<double> relevance_steps_;
  AlignedVector<float> scores_;
  std::vector<float> candidates_;
  std::vector<float> row_;
};

}  // namespace somato
