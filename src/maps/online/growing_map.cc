#include "maps/online/growing_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/kernels/batch_kernels.h"
#include "maps/som/initial_weights.h"
#include "maps/som/map_parts.h"
#include "maps/som/product_reading.h"
#include "maps/som/som_preparation.h"
#include "maps/som/stop.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::uint64_t kIterationsBetweenReports = 64;
constexpr std::uint64_t kMomentsOfGrowth = 100;

}  // namespace

const Declarations<GrowthParameters>& GrowthParameters::declarations() {
  using P = GrowthParameters;
  static const auto declared =
      Declarations<P>()
          .add("iterations", &P::iterations, "", Range::between(1, 1e15),
               "Number of draws. Automatic: 10 for each sample; with growing cells, as many as "
               "insert most_neurons neurons. Not given in the paper.")
          .add("draws", &P::draws, "", Range::any(),
               "Whether a sample can be drawn again before all others. Not given in the paper.")
          .add("most_neurons", &P::most_neurons, "neurons",
               Range::between(4, NeuronGraph::kMostNeurons),
               "Number of neurons at which the map stops growing, and number of values of its "
               "activity, which are 0 where the map has fewer neurons. Not given in the paper.")
          .add("softmax", &P::softmax, "", Range::any(),
               "Form of the map's activity from its similarities s: s^m or exp(m s). Not given in "
               "the paper.")
          .add("softmax_exponent", &P::softmax_exponent, "", Range::above(0),
               "The m of the activity. Not given in the paper.")
          .add("activity_norm", &P::activity_norm, "", Range::any(),
               "Whether activities are divided by their sum or by that of the winner. Not given in "
               "the paper.")
          .add("seed", &P::seed, "", Range::between(0, 1e15), "Seed of initial weights and draws.");
  return declared;
}

Result<void> grow(GrowingMap& map, const GrowthParameters& parameters, const NamedSamples& named,
                  const Progress& progress, const TrainingObserver& observer) {
  const Samples& samples = named.samples;
  const std::uint64_t total = parameters.iterations.value();
  const Stop stop(progress, total, kIterationsBetweenReports);
  DrawSequence draws(parameters.draws, samples.count(), parameters.seed);
  std::vector<float> input(samples.size());
  std::uint64_t moment = 0;
  for (std::uint64_t t = 1; t <= total && !map.is_complete(); ++t) {
    const std::size_t drawn = draws.next();
    write_dense(samples[drawn], input);
    if (named.classes.empty()) {
      map.learn(input);
    } else {
      map.learn_named(input, named.classes[drawn]);
    }
    const bool is_last = t == total || map.is_complete();
    const bool is_moment = is_last || t * kMomentsOfGrowth / total > moment;
    moment = t * kMomentsOfGrowth / total;
    if (stop.after(is_last ? total : t) ||
        (observer && is_moment &&
         !observer({is_last ? total : t, total, 0.0, 0.0, map.neurons() * samples.size(),
                    [&] { return map.map(); }}))) {
      return Stop::error();
    }
  }
  return {};
}

Result<void> check_growing(const Samples& samples) {
  SOMATO_TRY_VOID(check_samples(samples));
  return check_range(samples);
}

void GrowingMap::refine(const Som& /*refined*/, const std::vector<std::size_t>& /*classes*/) {
  require(false, "a map that does not learn names cannot be refined by them");
}

double distance_score(Similarity similarity, std::span<const float> a, std::span<const float> b) {
  if (similarity == Similarity::kEuclidean) return GrowingWeights::squared_distance(a, b);
  return kernels::batch_table().absolute_distance(a.data(), b.data(), a.size());
}

double distance_of_score(Similarity similarity, double score) {
  return similarity == Similarity::kEuclidean ? std::sqrt(score) : score;
}

GrowingWeights::GrowingWeights(const Som& som)
    : similarity_(som.parameters().similarity),
      rows_(som.weights().to_matrix()),
      origins_(som.neurons()) {
  number_anew();
}

void GrowingWeights::number_anew() {
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) origins_[neuron] = neuron;
}

void GrowingWeights::add_from(const GrowingWeights& others, std::size_t neuron) {
  add(others[neuron]);
  origins_.back() = others.origins_[neuron];
}

void GrowingWeights::add(std::span<const float> weights) {
  require(weights.size() == rows_.columns(), "a neuron needs a weight for each element");
  const std::vector<float> copy(weights.begin(), weights.end());  // may be one of the rows
  std::copy(copy.begin(), copy.end(), rows_.add_row().begin());
  origins_.emplace_back();
}

void GrowingWeights::add_between(std::span<const float> a, std::span<const float> b) {
  std::vector<float> mean(rows_.columns());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = static_cast<float>(0.5 * (double{a[i]} + double{b[i]}));
  }
  add(mean);
}

void GrowingWeights::remove(const std::vector<std::size_t>& neurons) {
  const auto numbers = numbers_after(this->neurons(), neurons);
  Matrix<float> left(this->neurons() - neurons.size(), rows_.columns());
  NeuronOrigins origins(left.rows());
  for (std::size_t neuron = 0; neuron < numbers.size(); ++neuron) {
    if (!numbers[neuron]) continue;
    const auto row = rows_.row(neuron);
    std::copy(row.begin(), row.end(), left.row(*numbers[neuron]).begin());
    origins[*numbers[neuron]] = origins_[neuron];
  }
  rows_ = std::move(left);
  origins_ = std::move(origins);
}

void GrowingWeights::place(std::size_t neuron, std::span<const float> input) {
  std::copy(input.begin(), input.end(), rows_.row(neuron).begin());
}

void GrowingWeights::move(std::size_t neuron, std::span<const float> input, double rate) {
  const std::span<float> row = rows_.row(neuron);
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = static_cast<float>(double{row[i]} + rate * (double{input[i]} - double{row[i]}));
  }
}

double GrowingWeights::squared_distance(std::span<const float> a, std::span<const float> b) {
  return kernels::batch_table().squared_distance(a.data(), b.data(), a.size());
}

double GrowingWeights::distance(std::size_t neuron, std::span<const float> input) const {
  return distance_of_score(similarity_, distance_score(similarity_, rows_.row(neuron), input));
}

Winners GrowingWeights::nearest_two(std::span<const float> input) const {
  BestTwo best;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    best.meet(distance_score(similarity_, rows_.row(neuron), input), neuron);
  }
  return best.winners();
}

std::pair<std::size_t, std::size_t> GrowingWeights::nearest_pair() const {
  std::pair<std::size_t, std::size_t> nearest{0, 1};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < neurons(); ++a) {
    for (std::size_t b = a + 1; b < neurons(); ++b) {
      const double distance = distance_score(similarity_, rows_.row(a), rows_.row(b));
      if (distance >= least) continue;
      least = distance;
      nearest = {a, b};
    }
  }
  return nearest;
}

Result<std::vector<std::uint64_t>> counts_from(const Archive& archive, const std::string& name,
                                               std::size_t count, std::uint64_t most,
                                               const std::string& where) {
  SOMATO_TRY(const auto found, archive.get<Array<std::int64_t>>(name, where));
  if (found->values.size() != count || found->shape.size() != 1) {
    return damaged_model("'" + name + "' does not fit the map", where);
  }
  for (const std::int64_t value : found->values) {
    if (value < 0 || std::cmp_greater(value, most)) {
      return damaged_model("'" + name + "' contains an invalid number", where);
    }
  }
  return std::vector<std::uint64_t>(found->values.begin(), found->values.end());
}

Result<std::vector<double>> numbers_from(const Archive& archive, const std::string& name,
                                         std::size_t count, double least, double most,
                                         const std::string& where) {
  SOMATO_TRY(const auto found, archive.get<Array<double>>(name, where));
  if (found->values.size() != count || found->shape.size() != 1) {
    return damaged_model("'" + name + "' does not fit the map", where);
  }
  for (const double value : found->values) {
    const bool is_possible = value >= least && value <= most;  // false for NaN
    if (!is_possible) {
      return damaged_model("'" + name + "' contains an invalid number", where);
    }
  }
  return found->values;
}

void add_counts(Archive& archive, std::string name, const std::vector<std::uint64_t>& counts) {
  archive.add(std::move(name),
              Array<std::int64_t>{{counts.size()}, {counts.begin(), counts.end()}});
}

std::vector<std::optional<std::size_t>> numbers_after(std::size_t neurons,
                                                      const std::vector<std::size_t>& removed) {
  std::vector<std::optional<std::size_t>> numbers(neurons);
  auto next = removed.begin();
  std::size_t left = 0;
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    if (next != removed.end() && *next == neuron) {
      ++next;
    } else {
      numbers[neuron] = left++;
    }
  }
  return numbers;
}

std::vector<std::size_t> drawn_samples(const Samples& samples, std::size_t count,
                                       std::uint64_t seed) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = count;
  parameters.initial_weights = InitialWeights::kSamples;
  parameters.seed = seed;
  return initial_samples(parameters, samples.count());
}

GrowingWeights drawn_weights(const Samples& samples, std::size_t count, std::uint64_t seed,
                             Similarity similarity) {
  GrowingWeights weights(samples.size(), similarity);
  std::vector<float> row(samples.size());
  for (const std::size_t sample : drawn_samples(samples, count, seed)) {
    write_dense(samples[sample], row);
    weights.add(row);
  }
  return weights;
}

SomParameters parameters_of_grown(const GrowthParameters& parameters, std::size_t rows,
                                  std::size_t columns, Similarity similarity) {
  SomParameters map;
  map.rows = rows;
  map.columns = columns;
  map.iterations = parameters.iterations;
  map.arithmetic = Arithmetic::kPlain;
  map.similarity = similarity;
  map.softmax = parameters.softmax;
  map.softmax_exponent = parameters.softmax_exponent;
  map.activity_norm = parameters.activity_norm;
  map.seed = parameters.seed;
  return resolve(map, 1, 1).value();
}

}  // namespace somato
