#include "maps/training/glvq.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/core/elementary.h"
#include "base/core/lanes.h"
#include "maps/som/map_rows.h"
#include "somato/core/check.h"
#include "somato/maps/labels.h"

namespace somato {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// An update changes the logarithm of a relevance by at most this, so that few extreme samples do
// not decide.
constexpr double kMostStep = 1.0;

// Weights keep their precision in the unit of the input, for pictures and files.
constexpr double kLeastRelevance = 1e-6;

// For each neuron the nearest sample seen so far.
class NearestSamples {
 public:
  explicit NearestSamples(std::size_t neurons) : distances_(neurons, kFar), samples_(neurons, 0) {}

  void add(std::span<const float> scores, std::size_t sample) {
    for (std::size_t neuron = 0; neuron < samples_.size(); ++neuron) {
      if (scores[neuron] >= distances_[neuron]) continue;
      distances_[neuron] = scores[neuron];
      samples_[neuron] = sample;
    }
  }

  std::size_t operator[](std::size_t neuron) const { return samples_[neuron]; }

 private:
  std::vector<float> distances_;
  std::vector<std::size_t> samples_;
};

// The derivative of the sigmoid 1 / (1 + e^-sx) divided by its greatest value, s / 4.
double relative_slope(double steepness, double x) {
  const double sigmoid = 1.0 / (1.0 + exponential(-steepness * x));
  return 4.0 * sigmoid * (1.0 - sigmoid);
}

}  // namespace

NeuronClasses classes_of_neurons(const Som& som, const Samples& seen,
                                 const std::vector<std::size_t>& classes) {
  require(seen.count() > 0 && classes.size() == seen.count(), "every sample has a class");
  NeuronVotes votes(som.neurons());
  NearestSamples nearest(som.neurons());
  AlignedVector<float> scores(som.weights().padded_rows());
  const auto of_neurons = std::span<const float>(scores).first(som.neurons());
  std::vector<float> row(seen.size());
  for (std::size_t i = 0; i < seen.count(); ++i) {
    write_dense(seen[i], row);
    const std::vector<KnownRun> runs = known_runs(row);
    const KnownScores known(som.parameters(), row, runs);
    known.write(kernels::lanes(som.weights()), som.neurons(), scores.data());
    votes.add(known.winner(som, of_neurons), classes[i]);
    nearest.add(of_neurons, i);
  }
  const NeuronLabels labels = votes.labels();
  NeuronClasses found;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    if (!labels[neuron]) ++found.named_by_nearest;
    found.of_neuron.push_back(labels[neuron].value_or(classes[nearest[neuron]]));
  }
  return found;
}

Glvq::Glvq(Som& som, std::vector<std::size_t> class_of_neuron, double neighbours,
           std::vector<bool> varying)
    : som_(som),
      weights_(weights_to_change(som)),
      class_of_neuron_(std::move(class_of_neuron)),
      neighbours_(neighbours),
      varying_(std::move(varying)),
      relevance_steps_(weights_.columns()),
      scores_(weights_.padded_rows()),
      candidates_(som.neurons()),
      row_(weights_.columns()) {
  require(class_of_neuron_.size() == som.neurons(), "every neuron has a class");
  if (varying_.empty()) varying_.assign(weights_.columns(), true);
  require(varying_.size() == weights_.columns(), "it is known of every element whether it varies");
  varying_count_ = static_cast<std::size_t>(std::ranges::count(varying_, true));
  for (const std::size_t one : class_of_neuron_) {
    if (one >= neurons_of_class_.size()) neurons_of_class_.resize(one + 1);
    ++neurons_of_class_[one];
  }
}

bool Glvq::has_both_sides(std::size_t the_class) const {
  if (the_class >= neurons_of_class_.size()) return false;
  const std::size_t neurons = neurons_of_class_[the_class];
  return neurons > 0 && neurons < class_of_neuron_.size();
}

void Glvq::learn(std::span<const float> sample, std::size_t its_class, const GlvqStep& step) {
  if (!has_both_sides(its_class)) return;
  const std::vector<KnownRun> runs = known_runs(sample);
  const KnownScores known(som_.parameters(), sample, runs);
  known.write(kernels::lanes(std::as_const(weights_)), som_.neurons(), scores_.data());
  Pair pair{nearest(known, its_class, true), nearest(known, its_class, false)};
  pair.to_right = distance(known, pair.right);
  pair.to_wrong = distance(known, pair.wrong);
  const double sum = pair.to_right + pair.to_wrong;
  if (sum == 0.0) return;
  const double slope = relative_slope(step.steepness, (pair.to_right - pair.to_wrong) / sum);
  if (step.relevance_rate > 0.0) {
    add_relevance_steps(sample, runs, pair, step.relevance_rate * slope);
  }
  const double rate = 2.0 * step.learning_rate * slope;
  const double gain = rate * pair.to_wrong / sum;
  move(sample, runs, pair.right, gain);
  move(sample, runs, pair.wrong, -rate * pair.to_right / sum);
  if (neighbours_ == 0.0) return;
  for (const std::size_t neuron : som_.grid().neighbours(pair.right)) {
    if (class_of_neuron_[neuron] == its_class) move(sample, runs, neuron, neighbours_ * gain);
  }
}

// The derivative of the relative distance difference by the logarithm of a relevance, times the
// number of elements that vary, so that the rate is that of an element with an average share of the
// distance.
void Glvq::add_relevance_steps(std::span<const float> sample, const std::vector<KnownRun>& runs,
                               const Pair& pair, double rate) {
  const bool is_squared = som_.parameters().similarity == Similarity::kEuclidean;
  const auto part = [&](std::size_t neuron, std::size_t d) {
    const double difference = double{sample[d]} - double{weights_(neuron, d)};
    return is_squared ? difference * difference : std::fabs(difference);
  };
  const double sum = pair.to_right + pair.to_wrong;
  const double factor = 2.0 * rate * static_cast<double>(varying_count_) / sum;
  for (const KnownRun& run : runs) {
    for (std::size_t d = run.first; d < run.first + run.count; ++d) {
      const double change =
          pair.to_wrong / sum * part(pair.right, d) - pair.to_right / sum * part(pair.wrong, d);
      relevance_steps_[d] = std::fma(factor, change, relevance_steps_[d]);
    }
  }
}

void Glvq::update_relevances() {
  std::vector<double> relevances = som_.parameters().relevances;
  relevances.resize(weights_.columns(), 1.0);
  double sum = 0.0;
  for (std::size_t d = 0; d < relevances.size(); ++d) {
    if (!varying_[d]) continue;
    relevances[d] *= exponential(-std::clamp(relevance_steps_[d], -kMostStep, kMostStep));
    relevance_steps_[d] = 0.0;
    sum += relevances[d];
  }
  const double factor = static_cast<double>(varying_count_) / sum;
  for (std::size_t d = 0; d < relevances.size(); ++d) {
    if (varying_[d]) relevances[d] = std::max(relevances[d] * factor, kLeastRelevance);
  }
  som_.set_relevances(std::move(relevances));
}

// Among the neurons of the class, or of all others.
std::size_t Glvq::nearest(const KnownScores& known, std::size_t the_class, bool of_class) {
  for (std::size_t neuron = 0; neuron < candidates_.size(); ++neuron) {
    const bool counts = (class_of_neuron_[neuron] == the_class) == of_class;
    candidates_[neuron] = counts ? scores_[neuron] : kFar;
  }
  return known.winner(som_, candidates_);
}

double Glvq::distance(const KnownScores& known, std::size_t neuron) {
  weights_.copy_row(neuron, row_);
  return known.exact(row_);
}

void Glvq::move(std::span<const float> sample, const std::vector<KnownRun>& runs,
                std::size_t neuron, double gain) {
  for (const KnownRun& run : runs) {
    for (std::size_t d = run.first; d < run.first + run.count; ++d) {
      const auto weight = double{weights_(neuron, d)};
      weights_(neuron, d) = static_cast<float>(std::fma(gain, double{sample[d]} - weight, weight));
    }
  }
}

}  // namespace somato
