#include "somato/maps/som_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/core/elementary.h"
#include "base/core/threads.h"
#include "maps/analysis/rank_measures.h"
#include "maps/analysis/topographic_product.h"
#include "maps/grid/neighbourhood.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr double kNoSamples = std::numeric_limits<double>::quiet_NaN();

double quotient(double sum, std::size_t count) {
  return count == 0 ? kNoSamples : sum / static_cast<double>(count);
}

// The numbers of the samples whose distances are ranked, ascending.
std::vector<std::size_t> numbers_to_rank(std::size_t samples, const MeasureParameters& parameters) {
  std::vector<std::size_t> numbers(samples);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  if (samples <= parameters.ranked_samples) return numbers;
  Random random(parameters.seed, Stream::kGroupings);
  shuffle(numbers, random);
  numbers.resize(parameters.ranked_samples);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// The radius that training ended with; none for a map that was trained without.
std::optional<double> final_radius(const SomParameters& parameters) {
  const bool scheduled =
      parameters.radius_start && parameters.radius_end && parameters.radius_reached_at;
  const bool has_length = parameters.training == Training::kBatch || parameters.iterations;
  if (!scheduled || !has_length) return std::nullopt;
  return parameters.radius().at(parameters.steps());
}

double sample_distortion(const Som& som, const SignalView& sample, std::span<const double> around,
                         SomWorkspace& workspace) {
  double sum = 0.0;
  for (std::size_t j = 0; j < som.neurons(); ++j) {
    if (around[j] == 0.0) continue;
    const double distance = som.distance(sample, j, workspace);
    sum += around[j] * distance * distance;
  }
  return sum;
}

std::vector<NeuronMeasures> measures_of_neurons(std::size_t neurons,
                                                const std::vector<std::size_t>& winners,
                                                const std::vector<double>& distances) {
  std::vector<NeuronMeasures> measures(neurons);
  for (std::size_t i = 0; i < winners.size(); ++i) {
    NeuronMeasures& of = measures[winners[i]];
    ++of.samples;
    of.mean_distance += distances[i];
    of.greatest_distance = std::max(of.greatest_distance, distances[i]);
  }
  for (NeuronMeasures& of : measures) {
    of.share = quotient(static_cast<double>(of.samples), winners.size());
    of.mean_distance = quotient(of.mean_distance, of.samples);
    if (of.samples == 0) of.greatest_distance = kNoSamples;
  }
  return measures;
}

// The samples of each class that each neuron wins.
using HitsOfClasses = std::vector<std::map<std::size_t, std::size_t>>;

HitsOfClasses hits_of_classes(const std::vector<std::size_t>& winners,
                              const std::vector<std::size_t>& classes) {
  HitsOfClasses hits(*std::max_element(classes.begin(), classes.end()) + 1);
  for (std::size_t i = 0; i < classes.size(); ++i) ++hits[classes[i]][winners[i]];
  return hits;
}

double entropy_of(const std::map<std::size_t, std::size_t>& hits, std::size_t samples) {
  const double inverse_log2 = 1.0 / natural_log(2.0);
  double entropy = 0.0;
  for (const auto& [neuron, count] : hits) {
    const double share = quotient(static_cast<double>(count), samples);
    entropy -= share * natural_log(share) * inverse_log2;
  }
  return entropy;
}

std::vector<ClassMeasures> measures_of_classes(const std::vector<NeuronMeasures>& neurons,
                                               const std::vector<std::size_t>& winners,
                                               const std::vector<double>& distances,
                                               const std::vector<std::size_t>& classes) {
  if (classes.empty()) return {};
  const HitsOfClasses hits = hits_of_classes(winners, classes);
  std::vector<ClassMeasures> measures(hits.size());
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ++measures[classes[i]].samples;
    measures[classes[i]].quantization_error += distances[i];
  }
  for (std::size_t c = 0; c < hits.size(); ++c) {
    ClassMeasures& of = measures[c];
    of.neurons = hits[c].size();
    of.quantization_error = quotient(of.quantization_error, of.samples);
    of.entropy = of.samples == 0 ? kNoSamples : entropy_of(hits[c], of.samples);
    for (const auto& [neuron, count] : hits[c]) {
      const auto own = static_cast<double>(count);
      of.purity += own * quotient(own, neurons[neuron].samples);
    }
    of.purity = quotient(of.purity, of.samples);
  }
  return measures;
}

}  // namespace

const std::vector<std::pair<SomMeasure, std::string>>& Choices<SomMeasure>::all() {
  static const std::vector<std::pair<SomMeasure, std::string>> choices{
      {SomMeasure::kQuantizationError, "quantization_error"},
      {SomMeasure::kTopographicError, "topographic_error"},
      {SomMeasure::kDistortion, "distortion"},
      {SomMeasure::kTopographicProduct, "topographic_product"},
      {SomMeasure::kTrustworthiness, "trustworthiness"},
      {SomMeasure::kContinuity, "continuity"},
      {SomMeasure::kNeighbourhoodPreservation, "neighbourhood_preservation"},
      {SomMeasure::kExplainedVariance, "explained_variance"}};
  return choices;
}

const Declarations<MeasureParameters>& MeasureParameters::declarations() {
  using P = MeasureParameters;
  static const auto declared =
      Declarations<P>()
          .add("neighbours", &P::neighbours, "samples", Range::between(1, 1e9),
               "The k of trustworthiness, continuity and neighbourhood_preservation: how many "
               "nearest samples are compared. The default is that of scikit-learn.")
          .add("ranked_samples", &P::ranked_samples, "samples", Range::between(3, 1e9),
               "The most samples whose distances are ranked for these three measures, which takes "
               "the square of their number; a random subset represents more.")
          .add("shuffles", &P::shuffles, "maps", Range::between(0, 1e6),
               "How many maps are trained and measured on data with shuffled columns, as the "
               "measures that chance gives; each takes as long as training the map.")
          .add("seed", &P::seed, "", Range::between(0, 1e15),
               "Seed of the random subset and of the first shuffle.");
  return declared;
}

SomMeasurement::SomMeasurement(const Som& som, std::size_t samples, std::vector<SomMeasure> chosen,
                               const MeasureParameters& parameters, std::size_t threads)
    : som_(som),
      chosen_(std::move(chosen)),
      parameters_(parameters),
      threads_(threads),
      quality_(som, threads),
      features_(som, threads),
      samples_(samples) {
  if (ranks()) ranked_ = numbers_to_rank(samples, parameters_);
  winners_.reserve(samples);
  distances_.reserve(samples);
}

bool SomMeasurement::wants(SomMeasure measure) const {
  return std::find(chosen_.begin(), chosen_.end(), measure) != chosen_.end();
}

bool SomMeasurement::ranks() const {
  return wants(SomMeasure::kTrustworthiness) || wants(SomMeasure::kContinuity) ||
         wants(SomMeasure::kNeighbourhoodPreservation);
}

void SomMeasurement::keep_ranked(const Samples& samples) {
  const std::size_t first = winners_.size();
  const auto next = ranked_.begin() + static_cast<std::ptrdiff_t>(ranked_samples_.count());
  for (auto i = next; i != ranked_.end() && *i < first + samples.count(); ++i) {
    ranked_samples_.add(samples[*i - first]);
  }
}

void SomMeasurement::add_distortion(const Samples& samples,
                                    const std::vector<std::size_t>& winners) {
  const std::optional<double> radius = final_radius(som_.parameters());
  if (!radius) return;
  std::vector<double> sums(samples.count());
  for_each_range(samples.count(), threads_, [&](std::size_t begin, std::size_t end) {
    Neighbourhood neighbourhood(som_.grid(), som_.parameters().neighbourhood);
    std::vector<double> around(som_.neurons());
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      neighbourhood.around(winners[i], *radius, around);
      sums[i] = sample_distortion(som_, samples[i], around, workspace);
    }
  });
  distortion_ = std::accumulate(sums.begin(), sums.end(), distortion_);
}

void SomMeasurement::add(const Samples& samples) {
  require(winners_.size() + samples.count() <= samples_, "SomMeasurement: too many samples");
  const std::vector<std::size_t> winners = quality_.add(samples);
  std::vector<double> distances(samples.count());
  for_each_range(samples.count(), threads_, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = som_.distance(samples[i], winners[i], workspace);
    }
  });
  if (wants(SomMeasure::kDistortion)) add_distortion(samples, winners);
  if (wants(SomMeasure::kExplainedVariance)) features_.add(samples, winners);
  keep_ranked(samples);
  winners_.insert(winners_.end(), winners.begin(), winners.end());
  distances_.insert(distances_.end(), distances.begin(), distances.end());
}

void SomMeasurement::write_ranks(SomMeasures& measures) const {
  if (!ranks()) return;
  std::vector<std::size_t> winners;
  winners.reserve(ranked_.size());
  for (const std::size_t sample : ranked_) winners.push_back(winners_[sample]);
  const RankMeasures ranks =
      measure_ranks(som_, ranked_samples_.samples(), winners, parameters_.neighbours, threads_);
  measures.ranked_samples = ranked_.size();
  measures.values[SomMeasure::kTrustworthiness] = ranks.trustworthiness;
  measures.values[SomMeasure::kContinuity] = ranks.continuity;
  measures.values[SomMeasure::kNeighbourhoodPreservation] = ranks.neighbourhood_preservation;
}

SomMeasures SomMeasurement::measures(const std::vector<std::size_t>& classes) const {
  require(winners_.size() == samples_, "SomMeasurement: samples are missing");
  require(classes.empty() || classes.size() == samples_, "each sample needs a class");
  SomMeasures measures;
  auto& values = measures.values;
  const SomQuality quality = quality_.quality();
  values[SomMeasure::kQuantizationError] = quality.quantization_error;
  values[SomMeasure::kTopographicError] = quality.topographic_error;
  const bool distorts = final_radius(som_.parameters()).has_value();
  values[SomMeasure::kDistortion] = distorts ? quotient(distortion_, samples_) : kNoSamples;
  if (wants(SomMeasure::kTopographicProduct)) {
    values[SomMeasure::kTopographicProduct] = topographic_product(som_, threads_);
  }
  write_ranks(measures);
  if (wants(SomMeasure::kExplainedVariance)) {
    values[SomMeasure::kExplainedVariance] = features_.explained_variance();
    measures.features = features_.features();
  }
  std::erase_if(values, [&](const auto& value) { return !wants(value.first); });
  measures.winners = winners_;
  measures.neurons = measures_of_neurons(som_.neurons(), winners_, distances_);
  measures.classes = measures_of_classes(measures.neurons, winners_, distances_, classes);
  return measures;
}

SomMeasures measure_som(const Som& som, const Samples& samples, std::vector<SomMeasure> chosen,
                        const MeasureParameters& parameters,
                        const std::vector<std::size_t>& classes, std::size_t threads) {
  SomMeasurement measurement(som, samples.count(), std::move(chosen), parameters, threads);
  measurement.add(samples);
  return measurement.measures(classes);
}

}  // namespace somato
