#include "maps/training/batch_training.h"
#include "base/core/lanes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/core/threads.h"
#include "base/kernels/batch_kernels.h"
#include "maps/grid/neighbourhood_mixing.h"
#include "maps/reading/winner_search.h"
#include "maps/som/initial_weights.h"
#include "maps/som/map_rows.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr double kLeastReach = 0x1p-1000;

}  // namespace

BatchEpoch::BatchEpoch(Som& som, const SumScales& scales, std::size_t threads)
    : som_(som),
      threads_(threads),
      scales_(scales),
      sums_(som.elements().count() + 1, som.neurons()) {
  weights_to_change(som);  // before threads read them
}

// A Euclidean distance is at most the sum of two lengths, and no other exceeds it by more than the
// root of the number of elements.
void BatchEpoch::measure(double longest) {
  double longest_weights = 0.0;
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    double square = 0.0;
    for (std::size_t d = 0; d < som_.elements().count(); ++d) {
      const double weight = som_.weights()(neuron, d);
      square += weight * weight;
    }
    longest_weights = std::max(longest_weights, std::sqrt(square));
  }
  distance_scale_ = scales_.scale_for((longest + longest_weights) *
                                      std::sqrt(static_cast<double>(som_.elements().count())));
}

void BatchEpoch::add_distances(const Samples& samples, const std::vector<std::size_t>& winners) {
  std::vector<std::int64_t> integers(samples.count());
  for_each_range(samples.count(), threads_, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      const double distance = som_.distance(samples[i], winners[i], workspace);
      integers[i] = static_cast<std::int64_t>(distance * distance_scale_);
    }
  });
  for (const std::int64_t integer : integers) distances_ += integer;
}

double BatchEpoch::mean_distance(std::size_t samples) const {
  return static_cast<double>(distances_) / distance_scale_ / static_cast<double>(samples);
}

std::vector<std::size_t> BatchEpoch::add(const Samples& seen) {
  std::vector<std::size_t> winners = winners_of_seen(som_, seen, threads_);
  if (distance_scale_ != 0.0) add_distances(seen, winners);
  for (const std::size_t winner : winners) ++sums_(som_.elements().count(), winner);
  if (seen.is_sparse()) {
    for (std::size_t i = 0; i < seen.count(); ++i) {
      const SignalView sample = seen[i];
      for (std::size_t k = 0; k < sample.values.size(); ++k) {
        const std::size_t element = sample.indices[k];
        sums_(element, winners[i]) += scales_.integer(element, sample.values[k]);
      }
    }
    return winners;
  }
  for_each_range((seen.size() + kDoubleLanes - 1) / kDoubleLanes, threads_,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t block = begin; block < end; ++block) {
                     add_block(seen, winners, block);
                   }
                 });
  return winners;
}

// Adds eight elements of all samples, or those that the last block has.
void BatchEpoch::add_block(const Samples& samples, const std::vector<std::size_t>& winners,
                           std::size_t block) {
  const std::size_t first = block * kDoubleLanes;
  std::int64_t* sums = sums_.data() + first * som_.neurons();
  if (first + kDoubleLanes <= samples.size()) {
    kernels::batch_table().add_by_winner(samples[0].values.data() + first, samples.size(),
                                         scales_.from(first), winners.data(), winners.size(), sums);
    return;
  }
  for (std::size_t i = 0; i < samples.count(); ++i) {
    for (std::size_t d = first; d < samples.size(); ++d) {
      sums[winners[i] * kDoubleLanes + d - first] += scales_.integer(d, samples[i].values[d]);
    }
  }
}

void BatchEpoch::combine(ProcessGroup& processes) {
  processes.sum({sums_.data(), sums_.padded_rows() * sums_.columns()});
  processes.sum({&distances_, 1});
}

// The sums over each neuron's neighbourhood, eight elements at a time.
class BatchEpoch::Means {
 public:
  Means(const BatchEpoch& epoch, const NeighbourhoodMixing& mixing)
      : epoch_(epoch),
        mixing_(mixing),
        numbers_(epoch.sums_.columns() * kDoubleLanes),
        mixed_(numbers_.size()) {}

  std::span<const double> of_block(std::size_t block) {
    const std::size_t first = block * kDoubleLanes;
    const std::int64_t* const sums = epoch_.sums_.data() + block * numbers_.size();
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      numbers_[i] = epoch_.scales_.number(first + i % kDoubleLanes, sums[i]);
    }
    mixing_.apply(numbers_, mixed_, workspace_);
    return mixed_;
  }

 private:
  const BatchEpoch& epoch_;
  const NeighbourhoodMixing& mixing_;
  AlignedVector<double> numbers_;
  AlignedVector<double> mixed_;
  NeighbourhoodMixing::Workspace workspace_;
};

// Weights of eight elements become their means.
void BatchEpoch::move_block(std::size_t block, std::span<const double> sums,
                            std::span<const double> totals) {
  const std::size_t first = block * kDoubleLanes;
  const std::size_t count = std::min(kDoubleLanes, som_.elements().count() - first);
  LaneMatrix<float>& weights = weights_to_change(som_);
  for (std::size_t neuron = 0; neuron < totals.size(); ++neuron) {
    if (totals[neuron] < kLeastReach) continue;
    for (std::size_t i = 0; i < count; ++i) {
      weights(neuron, first + i) =
          static_cast<float>(sums[neuron * kDoubleLanes + i] / totals[neuron]);
    }
  }
}

void BatchEpoch::finish(double radius) {
  const NeighbourhoodMixing mixing(som_.grid(), som_.parameters().neighbourhood, radius);
  const std::size_t elements = som_.elements().count();
  std::vector<double> totals(som_.neurons());
  Means counts(*this, mixing);
  const std::span<const double> last = counts.of_block(elements / kDoubleLanes);
  for (std::size_t neuron = 0; neuron < totals.size(); ++neuron) {
    totals[neuron] = last[neuron * kDoubleLanes + elements % kDoubleLanes];
  }
  const std::size_t blocks = (elements + kDoubleLanes - 1) / kDoubleLanes;
  for_each_range(blocks, threads_, [&](std::size_t begin, std::size_t end) {
    Means means(*this, mixing);
    for (std::size_t block = begin; block < end; ++block) {
      move_block(block, means.of_block(block), totals);
    }
  });
  if (som_.parameters().similarity == Similarity::kDotProduct) {
    AlignedVector<float> factors;
    normalize_rows(weights_to_change(som_), factors);
  }
}

std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads) {
  if (!has_weights_for(som, samples)) som.store_all();
  Samples storage;
  const Samples& seen = seen_samples(som, samples, storage);
  std::vector<float> low;
  std::vector<float> high;
  widen_ranges(seen, low, high);
  const SumScales scales(seen.count(), low, high);
  BatchEpoch epoch(som, scales, threads);
  std::vector<std::size_t> winners = epoch.add(seen);
  epoch.finish(radius);
  return winners;
}

std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads) {
  Samples storage;
  return winners_of_seen(som, seen_samples(som, samples, storage), threads);
}

}  // namespace somato
