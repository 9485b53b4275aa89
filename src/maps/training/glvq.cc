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

Glvq::Glvq(Som& som, std::vector<std::size_t> class_of_neuron, double neighbours)
    : som_(som),
      weights_(weights_to_change(som)),
      class_of_neuron_(std::move(class_of_neuron)),
      neighbours_(neighbours),
      scores_(weights_.padded_rows()),
      candidates_(som.neurons()),
      row_(weights_.columns()) {
  require(class_of_neuron_.size() == som.neurons(), "every neuron has a class");
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
  const std::size_t right = nearest(known, its_class, true);
  const std::size_t wrong = nearest(known, its_class, false);
  const double to_right = distance(known, right);
  const double to_wrong = distance(known, wrong);
  const double sum = to_right + to_wrong;
  if (sum == 0.0) return;
  const double slope = relative_slope(step.steepness, (to_right - to_wrong) / sum);
  const double rate = 2.0 * step.learning_rate * slope;
  const double gain = rate * to_wrong / sum;
  move(sample, runs, right, gain);
  move(sample, runs, wrong, -rate * to_right / sum);
  if (neighbours_ == 0.0) return;
  for (const std::size_t neuron : som_.grid().neighbours(right)) {
    if (class_of_neuron_[neuron] == its_class) move(sample, runs, neuron, neighbours_ * gain);
  }
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
