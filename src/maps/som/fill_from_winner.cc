#include "maps/som/fill_from_winner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

std::vector<std::size_t> known_elements(std::span<const float> sample) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!std::isnan(sample[i])) known.push_back(i);
  }
  return known;
}

std::size_t winner_by(const std::vector<std::size_t>& known, std::span<const float> sample,
                      const Som& som) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t winner = 0;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    double sum = 0.0;
    for (std::size_t i = 0; i < known.size() && sum <= least; ++i) {
      const double difference = double{sample[known[i]]} - double{som.weight(neuron, known[i])};
      sum = std::fma(difference, difference, sum);
    }
    if (sum >= least) continue;
    least = sum;
    winner = neuron;
  }
  return winner;
}

void fill_from_winner(const Som& som, std::span<float> sample) {
  const std::vector<std::size_t> known = known_elements(sample);
  if (known.size() == sample.size()) return;
  const std::size_t winner = winner_by(known, sample, som);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (std::isnan(sample[i])) sample[i] = som.weight(winner, i);
  }
}

}  // namespace

Result<void> check_takes_incomplete(const Som& som) {
  const SomParameters& parameters = som.parameters();
  const bool euclidean = parameters.similarity == Similarity::kEuclidean;
  if (euclidean && !parameters.normalize_input.value_or(false)) return {};
  return fail(ErrorKind::kUsage,
              euclidean ? "the map scales rows to length 1, which missing values leave unknown"
                        : "the map compares by inner products, which missing values leave unknown",
              {}, "use the means of the columns");
}

Samples filled_from_winners(const Som& som, const Samples& samples) {
  require(samples.size() == som.input_size(), "samples have as many elements as the map's inputs");
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    write_dense(samples[i], rows.row(i));
    fill_from_winner(som, rows.row(i));
  }
  return Samples(std::move(rows));
}

}  // namespace somato
