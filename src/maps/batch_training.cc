#include "somato/maps/batch_training.h"

#include <algorithm>
#include <cmath>

#include "core/kernels.h"
#include "maps/map_rows.h"
#include "somato/core/threads.h"
#include "somato/maps/neighbourhood.h"
#include "somato/maps/som_training.h"

namespace somato {

BatchEpoch::BatchEpoch(Som& som, std::size_t threads)
    : som_(som),
      threads_(threads),
      sums_(som.neurons(), som.elements().count()),
      counts_(som.neurons()) {}

std::vector<std::size_t> BatchEpoch::add(const Samples& samples) {
  Samples storage;
  const Samples& prepared = prepared_samples(som_.parameters(), samples, storage);
  std::vector<std::size_t> winners = winners_of(som_, prepared, threads_);
  std::vector<float> input(som_.elements().count());
  for (std::size_t i = 0; i < prepared.count(); ++i) {
    som_.elements().gather(prepared[i], input);
    const auto sum = sums_.row(winners[i]);
    for (std::size_t d = 0; d < input.size(); ++d) sum[d] += double{input[d]};
    counts_[winners[i]] += 1.0;
  }
  return winners;
}

// The neighbourhood is symmetric, so it is taken around the neuron that moves.
void BatchEpoch::move_to_mean(std::size_t neuron, std::span<const double> gains,
                              std::vector<double>& mean) {
  double total = 0.0;
  std::fill(mean.begin(), mean.end(), 0.0);
  for (std::size_t winner = 0; winner < gains.size(); ++winner) {
    if (counts_[winner] == 0.0 || gains[winner] == 0.0) continue;
    total = std::fma(gains[winner], counts_[winner], total);
    kernels::table<double>().add_scaled(sums_.row(winner).data(), gains[winner], mean.size(),
                                        mean.data());
  }
  if (total == 0.0) return;
  for (std::size_t d = 0; d < mean.size(); ++d) {
    som_.weights()(neuron, d) = static_cast<float>(mean[d] / total);
  }
}

void BatchEpoch::finish(double radius) {
  for_each_range(som_.neurons(), threads_, [&](std::size_t begin, std::size_t end) {
    Neighbourhood neighbourhood(som_.grid(), som_.parameters().neighbourhood);
    std::vector<double> gains(som_.neurons());
    std::vector<double> mean(som_.elements().count());
    for (std::size_t neuron = begin; neuron < end; ++neuron) {
      neighbourhood.around(neuron, radius, gains);
      move_to_mean(neuron, gains, mean);
    }
  });
  if (som_.parameters().similarity == Similarity::kDotProduct) {
    AlignedVector<float> factors;
    normalize_rows(som_.weights(), factors);
  }
}

std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads) {
  if (!has_weights_for(som, samples)) som.store_all();
  BatchEpoch epoch(som, threads);
  std::vector<std::size_t> winners = epoch.add(samples);
  epoch.finish(radius);
  return winners;
}

std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads) {
  std::vector<std::size_t> winners(samples.count());
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) winners[i] = som.winner(samples[i], workspace);
  });
  return winners;
}

}  // namespace somato
