#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_features.h"
#include "somato/maps/som_quality.h"

namespace somato {

/// A measure of a whole map for samples. Distances d(x, w) are those of the map: Som::distance().
/// docs/mathematics/measures.md gives the equations.
enum class SomMeasure {
  /// The mean distance of a sample from its winner.
  kQuantizationError,

  /// The share of samples whose winner and second winner do not share an edge.
  kTopographicError,

  /// The mean over the samples of sum over neurons j of h(winner, j) d(x, w_j)^2, where h is the
  /// neighbourhood function with the radius at the end of training (Lampinen and Oja, Clustering
  /// properties of hierarchical self-organizing maps, Journal of Mathematical Imaging and Vision 2,
  /// 1992). NaN for a map without a radius. Takes samples x neurons x features operations.
  kDistortion,

  /// The topographic product P (Bauer and Pawelzik, Quantifying the neighborhood preservation of
  /// self-organizing feature maps, IEEE Transactions on Neural Networks 3, 1992): below 0 if the
  /// map has too few dimensions for the data, above 0 if it has too many. It does not depend on the
  /// samples. NaN if two neurons have equal weights, if there is one neuron, or if a graph is not
  /// connected. Takes neurons^2 x features operations.
  kTopographicProduct,

  /// The trustworthiness and continuity of the map for the samples at the positions of their
  /// winners (Venna and Kaski, Neighborhood preservation in nonlinear projection methods, ICANN
  /// 2001, equations 1 and 2). Each is at most 1. NaN unless there are more than 2 k samples.
  kTrustworthiness,
  kContinuity,

  /// The mean share of the k nearest samples of a sample that are also among the k nearest on the
  /// map: Q_NX(k) of Lee and Verleysen, Quality assessment of dimensionality reduction: rank-based
  /// criteria, Neurocomputing 72, 2009. NaN unless there are more than 2 k samples.
  kNeighbourhoodPreservation,

  /// FeatureMeasurement::explained_variance().
  kExplainedVariance,
};

template <>
struct Choices<SomMeasure> {
  static const std::vector<std::pair<SomMeasure, std::string>>& all();
};

/// Parameters of measures.
struct MeasureParameters {
  std::size_t neighbours = 5;
  std::size_t ranked_samples = 2000;
  std::size_t shuffles = 0;
  std::uint64_t seed = 1;

  static const Declarations<MeasureParameters>& declarations();
};

/// The samples that one neuron wins.
struct NeuronMeasures {
  std::size_t samples = 0;
  double share = 0.0;              ///< The share of all samples.
  double mean_distance = 0.0;      ///< From the neuron; NaN without samples.
  double greatest_distance = 0.0;  ///< From the neuron; NaN without samples.
};

/// The samples of one class.
struct ClassMeasures {
  std::size_t samples = 0;
  std::size_t neurons = 0;  ///< The number of neurons that win them.
  double quantization_error =
      0.0;  ///< Their mean distance from their winners; NaN without samples.

  /// The mean over the samples of the share of their class among all samples of their neuron: 1 if
  /// the class shares no neuron. NaN without samples.
  double purity = 0.0;

  /// -sum p_j log2 p_j in bits, where p_j is the share of the samples that neuron j wins: 0 for one
  /// neuron, log2 m if they are spread evenly over m. NaN without samples.
  double entropy = 0.0;
};

/// Measures of a map for samples.
struct SomMeasures {
  std::map<SomMeasure, double> values;  ///< The chosen measures; NaN if not defined.
  std::size_t ranked_samples = 0;       ///< Samples whose distances have been ranked.
  std::vector<std::size_t> winners;     ///< The winner of each sample.
  std::vector<NeuronMeasures> neurons;  ///< One for each neuron.
  std::vector<ClassMeasures> classes;   ///< One for each class; empty without classes.
  std::vector<FeatureMeasures>
      features;  ///< One for each feature, if explained variance is chosen.
};

/// Measures a map for samples that are provided in parts. The division into parts and the number of
/// threads have no effect. Refers to the map, which must not change in the meantime.
class SomMeasurement {
 public:
  /// For `samples` samples. Of more than `ranked_samples`, a random subset of that number, which
  /// only depends on `seed`, represents all others in the measures that rank distances.
  SomMeasurement(const Som& som, std::size_t samples, std::vector<SomMeasure> chosen,
                 const MeasureParameters& parameters, std::size_t threads = 1);

  /// Adds the next samples.
  void add(const Samples& samples);

  /// The measures of all samples, and of their classes if `classes` is not empty. Throws
  /// InvalidArgument unless all samples have been added, and have a class each.
  SomMeasures measures(const std::vector<std::size_t>& classes = {}) const;

 private:
  bool wants(SomMeasure measure) const;
  bool ranks() const;
  void keep_ranked(const Samples& samples);
  void add_distortion(const Samples& samples, const std::vector<std::size_t>& winners);
  void write_ranks(SomMeasures& measures) const;

  const Som& som_;
  std::vector<SomMeasure> chosen_;
  MeasureParameters parameters_;
  std::size_t threads_;
  std::vector<std::size_t> ranked_;  // numbers of samples, ascending
  SampleCollector ranked_samples_;
  SomQualityMeasurement quality_;
  FeatureMeasurement features_;
  double distortion_ = 0.0;
  std::vector<std::size_t> winners_;
  std::vector<double> distances_;
  std::size_t samples_;
};

/// The same for samples in memory.
SomMeasures measure_som(const Som& som, const Samples& samples, std::vector<SomMeasure> chosen,
                        const MeasureParameters& parameters = {},
                        const std::vector<std::size_t>& classes = {}, std::size_t threads = 1);

/// The samples with the values of each feature in a random order, which is independent of those of
/// the other features: what the features have in common is lost, and each keeps its values.
Samples with_shuffled_features(const Samples& samples, std::uint64_t seed);

/// The measures that chance gives: those of `parameters.shuffles` maps, each trained with the
/// parameters of `som` on shuffled samples and measured for these. Shuffle i has the seed `seed +
/// i`. Takes as long as so many trainings and measurements, and memory for a second copy of the
/// samples; `progress` counts shuffles. Errors: kUsage for a map that grows, which training cannot
/// repeat; those of train_som(); kInterrupted.
Result<std::vector<SomMeasures>> measure_shuffled(const Som& som, const Samples& samples,
                                                  const std::vector<SomMeasure>& chosen,
                                                  const MeasureParameters& parameters,
                                                  const std::vector<std::size_t>& classes = {},
                                                  std::size_t threads = 1,
                                                  const Progress& progress = {});

}  // namespace somato
