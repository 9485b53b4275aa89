#include "somato/maps/som_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace somato {
namespace {

// Inner products pay when an iteration or epoch on samples x neurons values is cheaper than on
// features x neurons, and when there are enough of them to repay the products at the start and the
// end. A batch epoch on the weights is as cheap, value by value, as the products are.
bool inner_products_pay(const SomParameters& parameters, std::size_t samples,
                        std::size_t features) {
  constexpr std::size_t kMostSamples = 8192;  // their products take half a gigabyte
  if (!follows_from_products(parameters)) return false;
  if (samples > kMostSamples) return false;
  return parameters.training == Training::kBatch
             ? 8 * samples <= features && parameters.epochs >= 8
             : 2 * samples <= features && *parameters.iterations >= 2 * samples;
}

}  // namespace

const std::vector<std::pair<NeighbourhoodShape, std::string>>& Choices<NeighbourhoodShape>::all() {
  static const std::vector<std::pair<NeighbourhoodShape, std::string>> choices{
      {NeighbourhoodShape::kGaussian, "gaussian"},
      {NeighbourhoodShape::kBubble, "bubble"},
      {NeighbourhoodShape::kCutGaussian, "cut_gaussian"},
      {NeighbourhoodShape::kTriangular, "triangular"},
      {NeighbourhoodShape::kEpanechnikov, "epanechnikov"},
      {NeighbourhoodShape::kMexicanHat, "mexican_hat"}};
  return choices;
}

const std::vector<std::pair<Similarity, std::string>>& Choices<Similarity>::all() {
  static const std::vector<std::pair<Similarity, std::string>> choices{
      {Similarity::kEuclidean, "euclidean"},
      {Similarity::kDotProduct, "dot_product"},
      {Similarity::kManhattan, "manhattan"},
      {Similarity::kCosine, "cosine"},
      {Similarity::kChebyshev, "chebyshev"}};
  return choices;
}

const std::vector<std::pair<Training, std::string>>& Choices<Training>::all() {
  static const std::vector<std::pair<Training, std::string>> choices{{Training::kOnline, "online"},
                                                                     {Training::kBatch, "batch"}};
  return choices;
}

const std::vector<std::pair<Draws, std::string>>& Choices<Draws>::all() {
  static const std::vector<std::pair<Draws, std::string>> choices{
      {Draws::kWithReplacement, "with_replacement"},
      {Draws::kWithoutReplacement, "without_replacement"}};
  return choices;
}

const std::vector<std::pair<InitialWeights, std::string>>& Choices<InitialWeights>::all() {
  static const std::vector<std::pair<InitialWeights, std::string>> choices{
      {InitialWeights::kUniform, "uniform"},
      {InitialWeights::kRange, "range"},
      {InitialWeights::kSamples, "samples"},
      {InitialWeights::kLinear, "linear"}};
  return choices;
}

const std::vector<std::pair<Arithmetic, std::string>>& Choices<Arithmetic>::all() {
  static const std::vector<std::pair<Arithmetic, std::string>> choices{
      {Arithmetic::kAutomatic, "automatic"},
      {Arithmetic::kPlain, "plain"},
      {Arithmetic::kInnerProducts, "inner_products"}};
  return choices;
}

const std::vector<std::pair<Softmax, std::string>>& Choices<Softmax>::all() {
  static const std::vector<std::pair<Softmax, std::string>> choices{
      {Softmax::kPower, "power"}, {Softmax::kExponential, "exponential"}};
  return choices;
}

const std::vector<std::pair<ActivityNorm, std::string>>& Choices<ActivityNorm>::all() {
  static const std::vector<std::pair<ActivityNorm, std::string>> choices{
      {ActivityNorm::kSum, "sum"}, {ActivityNorm::kMaximum, "maximum"}};
  return choices;
}

const Declarations<SomParameters>& SomParameters::declarations() {
  using P = SomParameters;
  static const auto declared =
      Declarations<P>()
          .add("rows", &P::rows, "neurons", Range::between(1, 1 << 24),
               "Rows of the map; must be even on a hexagonal torus. Automatic: about 10 "
               "sqrt(samples) neurons in an approximately square map, between the normal and the "
               "big maps of Vesanto and others (2000); docs/decisions/0040-automatic-size.md.")
          .add("columns", &P::columns, "neurons", Range::between(1, 1 << 24),
               "Columns of the map. Automatic: as for rows.")
          .add("lattice", &P::lattice, "", Range::any(),
               "Layout of the neurons: rectangular with four neighbours, or hexagonal with six. "
               "The papers draw rectangular maps.")
          .add("topology", &P::topology, "", Range::any(),
               "Whether the map has borders, or opposite edges are joined.")
          .add("similarity", &P::similarity, "", Range::any(),
               "Criterion for the winner: the smallest Euclidean, manhattan (sum of the "
               "differences' "
               "magnitudes), chebyshev (greatest of them) or cosine distance (1 - cosine), or the "
               "greatest inner product with weights of length 1. It does not change how weights "
               "learn.")
          .add("normalize_input", &P::normalize_input, "", Range::any(),
               "Whether every input is scaled to Euclidean length 1; automatic: with dot_product "
               "only. Not given in the paper.")
          .add("initial_weights", &P::initial_weights, "", Range::any(),
               "Initial weights: uniform in [0, 1), uniform in each feature's range, random "
               "samples, "
               "or linear: on the plane of the two largest principal components, at most one "
               "standard deviation from the mean along each. Not given in the paper.")
          .add("training", &P::training, "", Range::any(),
               "Online training, with one random sample at a time as in the papers, or batch "
               "training, with all samples in each epoch.")
          .add("iterations", &P::iterations, "samples drawn", Range::between(0, 1e15),
               "Length of online training; automatic: 2000 as in P11, or 10 per sample if that is "
               "more; with an automatic size 100 per neuron, and at least 20,000.")
          .add("epochs", &P::epochs, "passes over all samples", Range::between(0, 1e9),
               "Length of batch training.")
          .add("tolerance", &P::tolerance, "", Range::between(0, 1),
               "Training continues after its epochs or iterations, with the final radius and "
               "learning rate, until checks of the quantization error find no relative improvement "
               "of more than this; 0: it does not continue, as in the papers.")
          .add(
              "patience", &P::patience, "checks", Range::between(1, 1e9),
              "Number of consecutive checks without such an improvement that end the training: one "
              "per epoch, in online training one per as many iterations as there are samples.")
          .add("most_checks", &P::most_checks, "checks", Range::between(1, 1e9),
               "Number of checks after which training ends in any case.")
          .add("draws", &P::draws, "", Range::any(),
               "How samples are drawn in online training. Not given in the paper.")
          .add("neighbourhood", &P::neighbourhood, "", Range::any(),
               "Neighbourhood function of the distance from the winner: a Gaussian, which may be "
               "cut "
               "at the radius; constant up to the radius (bubble); 0 at the radius and falling "
               "towards it as a line (triangular) or a parabola (epanechnikov); or negative beyond "
               "the radius (mexican_hat), which pushes weights away from the sample, in online "
               "training only.")
          .add("radius_schedule", &P::radius_schedule, "", Range::any(),
               "Course of the neighbourhood radius from start to end. Not given in the paper.")
          .add("radius_start", &P::radius_start, "neurons", Range::at_least(0),
               "Neighbourhood radius (a Gaussian's sigma) at the start; automatic: half of the "
               "longer side of the map. P11 gives 15 for the texture map, and the "
               "whole map for hardness.")
          .add("radius_end", &P::radius_end, "neurons", Range::at_least(0),
               "Neighbourhood radius at the end; automatic: 1 as in P11, or 0.5 if the map's size "
               "is automatic.")
          .add("radius_reached_at", &P::radius_reached_at, "iterations or epochs",
               Range::between(1, 1e15),
               "Iteration or epoch at which the radius reaches its final value, which it then "
               "keeps; automatic: the end of training.")
          .add("learning_rate_schedule", &P::learning_rate_schedule, "", Range::any(),
               "Course of the learning rate from start to end. Not given in the paper.")
          .add("learning_rate_start", &P::learning_rate_start, "", Range::between(0, 1),
               "Learning rate at the start of online training. Not given in the paper.")
          .add("learning_rate_end", &P::learning_rate_end, "", Range::between(0, 1),
               "Learning rate at the end of online training. Not given in the paper.")
          .add("learning_rate_reached_at", &P::learning_rate_reached_at, "iterations",
               Range::between(1, 1e15),
               "Iteration at which the learning rate reaches its final value, which it then keeps; "
               "automatic: the end of training. Not given in the paper.")
          .add("arithmetic", &P::arithmetic, "", Range::any(),
               "Method of computation in training; the map is the same up to rounding. Automatic: "
               "inner products if there are at least twice as many features, and iterations, as "
               "samples, or in batch training eight times as many features and 8 epochs; in a "
               "system, if the samples are whole explorations and their input does not change "
               "during training.")
          .add("softmax", &P::softmax, "", Range::any(),
               "Form of the map's activity from its similarities s: s^m or exp(m s). Not given in "
               "the paper.")
          .add("softmax_exponent", &P::softmax_exponent, "", Range::above(0),
               "The m of the activity; 10 in P11.")
          .add("activity_norm", &P::activity_norm, "", Range::any(),
               "Whether activities are divided by their sum or by that of the winner. Not given in "
               "the paper.")
          .add("seed", &P::seed, "", Range::between(0, 1e15),
               "Seed of initial weights and draws: the same seed gives identical results, bit by "
               "bit. A study uses first_seed instead.");
  return declared;
}

void decide_size(SomParameters& parameters, std::size_t samples) {
  auto& p = parameters;
  if (!p.is_size_automatic()) return;
  const double neurons = 10.0 * std::sqrt(static_cast<double>(samples));
  const auto at_least_one = [](double side) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(side)));
  };
  if (!p.rows) {
    p.rows =
        at_least_one(p.columns ? neurons / static_cast<double>(*p.columns) : std::sqrt(neurons));
    const bool must_be_even = p.lattice == Lattice::kHexagonal && p.topology == Topology::kTorus;
    if (must_be_even) *p.rows += *p.rows % 2;
  }
  if (!p.columns) p.columns = at_least_one(neurons / static_cast<double>(*p.rows));
  constexpr std::uint64_t kIterations = 100;  // a neuron
  constexpr std::uint64_t kLeastIterations = 20000;
  constexpr double kRadiusEnd = 0.5;  // neighbours then learn an eighth of the winner
  p.radius_end = p.radius_end.value_or(std::min(kRadiusEnd, p.radius_start.value_or(kRadiusEnd)));
  p.iterations = p.iterations.value_or(
      std::max<std::uint64_t>(kLeastIterations, kIterations * *p.rows * *p.columns));
}

namespace {

Result<void> check_shape(const SomParameters& parameters) {
  const bool refused = parameters.neighbourhood == NeighbourhoodShape::kMexicanHat &&
                       parameters.training == Training::kBatch;
  if (!refused) return {};
  return fail(ErrorKind::kUsage,
              "batch training cannot use the neighbourhood mexican_hat, whose negative factors can "
              "sum to 0 with the positive ones, so that the weighted mean of the samples does not "
              "exist",
              {}, "set 'training' to online, or choose another 'neighbourhood'");
}

// A single row or column of millions of neurons is a mistake, of which the training could not be
// stopped soon.
Result<void> check_given_side(const SomParameters& parameters) {
  constexpr std::size_t kMost = std::size_t{1} << 20;
  if (parameters.rows.value_or(1) <= kMost && parameters.columns.value_or(1) <= kMost) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("a side of more than {} neurons needs the other side, too", kMost),
              parameters.rows ? "rows" : "columns", "set 'rows' and 'columns'");
}

Result<void> check_arithmetic(const SomParameters& parameters) {
  if (parameters.arithmetic != Arithmetic::kInnerProducts || follows_from_products(parameters)) {
    return {};
  }
  return fail(ErrorKind::kUsage,
              parameters.layers.empty()
                  ? fmt::format("inner products do not give the distances of similarity '{}'",
                                choice_name(parameters.similarity))
                  : "inner products do not give the distances of layers",
              "arithmetic", "set 'arithmetic' to plain or leave it out");
}

Result<void> check_without_relevances(const SomParameters& parameters) {
  if (parameters.relevances.empty()) return {};
  return fail(ErrorKind::kUsage,
              "a training begins without relevances, which only a refinement learns", "relevances",
              "leave them out");
}

}  // namespace

Result<SomParameters> resolve(SomParameters parameters, std::size_t samples, std::size_t features) {
  if (parameters.is_size_automatic()) SOMATO_TRY_VOID(check_given_side(parameters));
  SOMATO_TRY_VOID(check_arithmetic(parameters));
  SOMATO_TRY_VOID(check_without_relevances(parameters));
  decide_size(parameters, samples);
  auto& p = parameters;
  SOMATO_TRY_VOID(check_shape(p));
  SOMATO_TRY_VOID(Grid::validate(*p.rows, *p.columns, p.lattice, p.topology));
  const auto longer_side = static_cast<double>(std::max(*p.rows, *p.columns));
  p.normalize_input = p.normalize_input.value_or(p.similarity == Similarity::kDotProduct);
  p.iterations = p.iterations.value_or(std::max<std::uint64_t>(2000, 10 * samples));
  p.radius_start = p.radius_start.value_or(longer_side / 2.0);
  p.radius_end = p.radius_end.value_or(1.0);
  p.radius_reached_at = p.radius_reached_at.value_or(std::max<std::uint64_t>(1, p.steps()));
  p.learning_rate_reached_at =
      p.learning_rate_reached_at.value_or(std::max<std::uint64_t>(1, p.steps()));
  if (p.arithmetic == Arithmetic::kAutomatic) {
    p.arithmetic =
        inner_products_pay(p, samples, features) ? Arithmetic::kInnerProducts : Arithmetic::kPlain;
  }
  for (const auto& [name, schedule] : {std::pair<std::string, Schedule>{"radius", p.radius()},
                                       {"learning rate", p.learning_rate()}}) {
    SOMATO_TRY_VOID(schedule.validate(name));
  }
  return parameters;
}

std::string reason_without_effect(const SomParameters& parameters, std::string_view name) {
  const bool of_online =
      name == "iterations" || name == "draws" || name.starts_with("learning_rate");
  if (parameters.training == Training::kBatch && of_online) return "training is batch";
  if (parameters.training == Training::kOnline && name == "epochs") return "training is online";
  const bool of_checks = name == "patience" || name == "most_checks";
  if (of_checks && !parameters.is_length_automatic()) return "tolerance is 0";
  const bool of_change = name.ends_with("_end") || name.ends_with("_reached_at");
  const ScheduleShape shape =
      name.starts_with("radius") ? parameters.radius_schedule : parameters.learning_rate_schedule;
  if (of_change && shape == ScheduleShape::kConstant) return "its schedule is constant";
  return {};
}

Error without_effect(std::string_view name, std::string_view reason, std::string_view where) {
  return {ErrorKind::kUsage, fmt::format("'{}' has no effect, because {}", name, reason),
          std::string(where), "leave it out"};
}

}  // namespace somato
