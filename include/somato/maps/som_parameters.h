#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/maps/grid.h"
#include "somato/maps/schedule.h"

namespace somato {

/// The neighbourhood function, which determines how much the neurons around a winner learn. It is 1
/// at the winner, and with radius 0 it is 0 elsewhere.
enum class NeighbourhoodShape {
  kGaussian,      ///< exp(-d^2 / (2 radius^2)) at distance d.
  kBubble,        ///< 1 up to the radius, 0 beyond.
  kCutGaussian,   ///< The Gaussian up to the radius, 0 beyond.
  kTriangular,    ///< max(0, 1 - d / radius).
  kEpanechnikov,  ///< max(0, 1 - d^2 / radius^2).
  kMexicanHat,    ///< (1 - d^2 / radius^2) exp(-d^2 / (2 radius^2)), negative beyond the radius;
                  ///< for online training only.
};

/// Criterion for the winner.
enum class Similarity {
  kEuclidean,   ///< The smallest distance of weights and input.
  kDotProduct,  ///< The greatest inner product of weights and input; weights have length 1.
  kManhattan,   ///< The smallest sum of the magnitudes of differences.
  kCosine,      ///< The smallest cosine distance 1 - (x . w) / (|x| |w|), which is 1 for zeros.
  kChebyshev,   ///< The smallest maximum of the magnitudes of differences.
};

/// Whether winners follow from inner products and lengths, as training by inner products requires.
constexpr bool follows_from_products(Similarity similarity) {
  return similarity == Similarity::kEuclidean || similarity == Similarity::kDotProduct;
}

/// Training method.
enum class Training {
  kOnline,  ///< One randomly drawn sample per iteration, as in the papers.
  kBatch,   ///< All samples in each epoch; each weight becomes a weighted mean. No learning rate.
};

/// Order of the samples in online training.
enum class Draws {
  kWithReplacement,     ///< Each draw from all samples.
  kWithoutReplacement,  ///< Every sample once, in random order, then again in a new order.
};

/// Initial weights.
enum class InitialWeights {
  kUniform,  ///< Uniform in [0, 1).
  kRange,    ///< Uniform between the minimum and the maximum of each feature in the samples.
  kSamples,  ///< Randomly drawn samples, without repeats if there are enough.
  kLinear,   ///< On the plane of the samples' two largest principal components (Kohonen 2001).
};

/// Method of computation in training; the trained map is the same up to rounding.
enum class Arithmetic {
  kAutomatic,      ///< Inner products if there are few samples and many features, else plain.
  kPlain,          ///< Computes with the weights.
  kInnerProducts,  ///< Computes with the inner products of weights and samples, in double
                   ///< precision.
};

/// Form of a map's activity, from its similarities s rectified at 0.
enum class Softmax {
  kPower,        ///< s^m.
  kExponential,  ///< exp(m s), the standard softmax.
};

/// Divisor of a map's activity.
enum class ActivityNorm {
  kSum,      ///< The sum of the activities, so that they sum to 1.
  kMaximum,  ///< The maximum activity, so that the winner has 1.
};

template <>
struct Choices<NeighbourhoodShape> {
  static const std::vector<std::pair<NeighbourhoodShape, std::string>>& all();
};
template <>
struct Choices<Similarity> {
  static const std::vector<std::pair<Similarity, std::string>>& all();
};
template <>
struct Choices<Training> {
  static const std::vector<std::pair<Training, std::string>>& all();
};
template <>
struct Choices<Draws> {
  static const std::vector<std::pair<Draws, std::string>>& all();
};
template <>
struct Choices<InitialWeights> {
  static const std::vector<std::pair<InitialWeights, std::string>>& all();
};
template <>
struct Choices<Arithmetic> {
  static const std::vector<std::pair<Arithmetic, std::string>>& all();
};
template <>
struct Choices<Softmax> {
  static const std::vector<std::pair<Softmax, std::string>>& all();
};
template <>
struct Choices<ActivityNorm> {
  static const std::vector<std::pair<ActivityNorm, std::string>>& all();
};

/// A group of neighbouring elements of an input, with a distance of its own.
struct Layer {
  std::string name;
  std::size_t first = 0;
  std::size_t count = 0;
  Similarity similarity = Similarity::kEuclidean;  ///< A distance: not kDotProduct.
  double weight = 1.0;                             ///< Above 0.
  /// The distance that counts as 1, above 0; automatic: the mean distance of training samples.
  std::optional<double> scale = {};

  bool operator==(const Layer&) const = default;
};

/// All parameters of a SOM. declarations() gives the meaning, unit and range of each.
struct SomParameters {
  std::optional<std::size_t> rows = {};
  std::optional<std::size_t> columns = {};
  Lattice lattice = Lattice::kRectangular;
  Topology topology = Topology::kPlane;
  Similarity similarity = Similarity::kEuclidean;
  std::optional<bool> normalize_input;
  InitialWeights initial_weights = InitialWeights::kRange;
  Training training = Training::kOnline;
  std::optional<std::uint64_t> iterations;
  std::uint64_t epochs = 20;
  double tolerance = 0.0;
  std::uint64_t patience = 3;
  std::uint64_t most_checks = 100;
  Draws draws = Draws::kWithReplacement;
  NeighbourhoodShape neighbourhood = NeighbourhoodShape::kGaussian;
  ScheduleShape radius_schedule = ScheduleShape::kLinear;
  std::optional<double> radius_start;
  std::optional<double> radius_end;
  std::optional<std::uint64_t> radius_reached_at;
  ScheduleShape learning_rate_schedule = ScheduleShape::kLinear;
  double learning_rate_start = 0.3;
  double learning_rate_end = 0.02;
  std::optional<std::uint64_t> learning_rate_reached_at;
  Arithmetic arithmetic = Arithmetic::kAutomatic;
  Softmax softmax = Softmax::kPower;
  double softmax_exponent = 10.0;
  ActivityNorm activity_norm = ActivityNorm::kMaximum;
  std::uint64_t seed = 1;

  /// The layers of the input, all its elements in order, or none (layers.h). Not declared, because
  /// they belong to the columns of the data.
  std::vector<Layer> layers = {};

  /// How much each element of an input counts in the distance: numbers above 0, or none where all
  /// count alike (Som::set_relevances()). Not declared, because a refinement learns them.
  std::vector<double> relevances = {};

  static const Declarations<SomParameters>& declarations();

  /// Whether a side of the map is derived from the number of samples.
  bool is_size_automatic() const { return !rows || !columns; }

  /// The number of neurons; if a side is automatic, only valid after decide_size().
  Grid grid() const { return {*rows, *columns, lattice, topology}; }

  /// The number of iterations or epochs, depending on the training method; only after resolve().
  std::uint64_t steps() const { return training == Training::kBatch ? epochs : *iterations; }

  /// Whether training continues after steps() until the quantization error no longer improves.
  bool is_length_automatic() const { return tolerance > 0.0; }

  /// The schedules; only after resolve().
  Schedule radius() const {
    return {radius_schedule, *radius_start, *radius_end, *radius_reached_at};
  }
  Schedule learning_rate() const {
    return {learning_rate_schedule, learning_rate_start, learning_rate_end,
            *learning_rate_reached_at};
  }
};

/// Whether winners of the map follow from inner products and lengths.
inline bool follows_from_products(const SomParameters& parameters) {
  return parameters.layers.empty() && follows_from_products(parameters.similarity);
}

/// Sets automatic sides: 10 sqrt(samples) neurons, in a grid as close to a square as possible, and
/// for such a map automatic `iterations`, 100 per neuron and at least 20,000, and an automatic
/// `radius_end`, 0.5 (docs/decisions/0040-automatic-size.md). Other parameters are unchanged.
void decide_size(SomParameters& parameters, std::size_t samples);

/// The parameters with all automatic values resolved for `samples` samples with `features`
/// elements, as stored in a model file. Fails (kUsage) if parameters contradict each other.
Result<SomParameters> resolve(SomParameters parameters, std::size_t samples, std::size_t features);

/// The reason why the parameter `name` has no effect with the other parameters, such as "training
/// is batch"; empty if it has an effect. Programs should report such a parameter to the user.
std::string reason_without_effect(const SomParameters& parameters, std::string_view name);

/// The error (kUsage) for a parameter that was set but has no effect.
Error without_effect(std::string_view name, std::string_view reason, std::string_view where);

}  // namespace somato
