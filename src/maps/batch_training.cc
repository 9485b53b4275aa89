#include "somato/maps/batch_training.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/kernels.h"
#include "maps/map_rows.h"
#include "somato/core/matrix.h"
#include "somato/core/threads.h"
#include "somato/maps/neighbourhood.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

// Sums of the samples by winner, and how many there are: double precision, in the samples' order.
struct WinnerSums {
  Matrix<double> sums;
  std::vector<double> counts;
};

WinnerSums sum_by_winner(const Som& som, const Samples& samples,
                         const std::vector<std::size_t>& winners) {
  WinnerSums result{Matrix<double>(som.neurons(), som.elements().count()),
                    std::vector<double>(som.neurons())};
  std::vector<float> input(som.elements().count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    som.elements().gather(samples[i], input);
    const auto sum = result.sums.row(winners[i]);
    for (std::size_t d = 0; d < input.size(); ++d) sum[d] += double{input[d]};
    result.counts[winners[i]] += 1.0;
  }
  return result;
}

// The weighted mean for one neuron; the neighbourhood is symmetric, so it is taken around it.
void move_to_mean(Som& som, std::size_t neuron, const WinnerSums& sums,
                  std::span<const double> gains, std::vector<double>& mean) {
  double total = 0.0;
  std::fill(mean.begin(), mean.end(), 0.0);
  for (std::size_t winner = 0; winner < gains.size(); ++winner) {
    if (sums.counts[winner] == 0.0 || gains[winner] == 0.0) continue;
    total = std::fma(gains[winner], sums.counts[winner], total);
    kernels::table<double>().add_scaled(sums.sums.row(winner).data(), gains[winner], mean.size(),
                                        mean.data());
  }
  if (total == 0.0) return;
  for (std::size_t d = 0; d < mean.size(); ++d) {
    som.weights()(neuron, d) = static_cast<float>(mean[d] / total);
  }
}

}  // namespace

std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads) {
  std::vector<std::size_t> winners(samples.count());
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) winners[i] = som.winner(samples[i], workspace);
  });
  return winners;
}

std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads) {
  if (!has_weights_for(som, samples)) som.store_all();
  Samples storage;
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  std::vector<std::size_t> winners = winners_of(som, prepared, threads);
  const WinnerSums sums = sum_by_winner(som, prepared, winners);
  for_each_range(som.neurons(), threads, [&](std::size_t begin, std::size_t end) {
    Neighbourhood neighbourhood(som.grid(), som.parameters().neighbourhood);
    std::vector<double> gains(som.neurons());
    std::vector<double> mean(som.elements().count());
    for (std::size_t neuron = begin; neuron < end; ++neuron) {
      neighbourhood.around(neuron, radius, gains);
      move_to_mean(som, neuron, sums, gains, mean);
    }
  });
  if (som.parameters().similarity == Similarity::kDotProduct) {
    AlignedVector<float> factors;
    normalize_rows(som.weights(), factors);
  }
  return winners;
}

}  // namespace somato
