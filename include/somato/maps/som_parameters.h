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
#include "somato/maps/neighbourhood.h"
#include "somato/maps/schedule.h"

namespace somato {

/// What makes a neuron the winner.
enum class Similarity {
  kEuclidean,   ///< The least distance of weights and input.
  kDotProduct,  ///< The greatest inner product of weights and input; weights have length 1.
};

/// How a map is trained.
enum class Training {
  kOnline,  ///< One randomly drawn sample an iteration, as in the papers.
  kBatch,   ///< All samples an epoch; each weight becomes a weighted mean. No learning rate.
};

/// How samples are drawn in online training.
enum class Draws {
  kWithReplacement,     ///< Each draw from all samples.
  kWithoutReplacement,  ///< Every sample once, in random order, then again in a new order.
};

/// Where weights start.
enum class InitialWeights {
  kUniform,  ///< Uniform in [0, 1).
  kRange,    ///< Uniform between the least and the greatest value of each feature in the samples.
  kSamples,  ///< Randomly drawn samples, without repeats while there are enough.
};

/// How training computes; the trained map is the same up to rounding.
enum class Arithmetic {
  kAutomatic,      ///< Inner products where samples are few and features many, else plain.
  kPlain,          ///< On the weights themselves.
  kInnerProducts,  ///< On the inner products of weights and samples, in double precision.
};

/// The form of a map's activity, from its similarities s rectified at 0.
enum class Softmax {
  kPower,        ///< s^m.
  kExponential,  ///< exp(m s), the textbook softmax.
};

/// What a map's activity is divided by.
enum class ActivityNorm {
  kSum,      ///< The activities' sum, so that they add up to 1.
  kMaximum,  ///< The greatest activity, so that the winner has 1.
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

/// Everything that decides what a SOM becomes, besides its samples. Declared in declarations(),
/// where the meaning, unit and range of each stands.
struct SomParameters {
  std::optional<std::size_t> rows = 15;
  std::optional<std::size_t> columns = 15;
  Lattice lattice = Lattice::kRectangular;
  Topology topology = Topology::kPlane;
  Similarity similarity = Similarity::kEuclidean;
  std::optional<bool> normalize_input;
  InitialWeights initial_weights = InitialWeights::kRange;
  Training training = Training::kOnline;
  std::optional<std::uint64_t> iterations;
  std::uint64_t epochs = 20;
  Draws draws = Draws::kWithReplacement;
  NeighbourhoodShape neighbourhood = NeighbourhoodShape::kGaussian;
  ScheduleShape radius_schedule = ScheduleShape::kLinear;
  std::optional<double> radius_start;
  double radius_end = 1.0;
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

  static const Declarations<SomParameters>& declarations();

  /// Whether the number of samples decides a side of the map.
  bool is_size_automatic() const { return !rows || !columns; }

  /// The neurons; only after decide_size() where a side is automatic.
  Grid grid() const { return {*rows, *columns, lattice, topology}; }

  /// Iterations or epochs, whichever the training counts in; only after resolve().
  std::uint64_t steps() const { return training == Training::kBatch ? epochs : *iterations; }

  /// The schedules; only after resolve().
  Schedule radius() const {
    return {radius_schedule, *radius_start, radius_end, *radius_reached_at};
  }
  Schedule learning_rate() const {
    return {learning_rate_schedule, learning_rate_start, learning_rate_end,
            *learning_rate_reached_at};
  }
};

/// Decides the sides that are automatic: 5 sqrt(samples) neurons, as near to a square as they can
/// be laid out (Vesanto, Himberg, Alhoniemi and Parhankangas, SOM Toolbox for Matlab 5, 2000), and
/// for such a map the automatic `iterations`: 500 a neuron (Kohonen, The Self-Organizing Map,
/// Proceedings of the IEEE 78, 1990). Other parameters stay as they are.
void decide_size(SomParameters& parameters, std::size_t samples);

/// The parameters with every automatic one decided for `samples` samples of `features` elements, as
/// a model file keeps them. Fails (kUsage) when parameters contradict each other.
Result<SomParameters> resolve(SomParameters parameters, std::size_t samples, std::size_t features);

/// Why the parameter `name` has no effect beside the others, such as "training is batch"; empty
/// when it has one. A person who sets such a parameter should be told.
std::string reason_without_effect(const SomParameters& parameters, std::string_view name);

/// The failure (kUsage) for a parameter that was set but has no effect.
Error without_effect(std::string_view name, std::string_view reason, std::string_view where);

}  // namespace somato
