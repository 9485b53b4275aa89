#include "maps/training/batch_training.h"
#include "base/core/lanes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/core/threads.h"
#include "base/kernels/batch_kernels.h"
#include "maps/grid/feature_ranges.h"
#include "maps/grid/neighbourhood_mixing.h"
#include "maps/reading/winner_search.h"
#include "maps/som/fill_from_winner.h"
#include "maps/som/initial_weights.h"
#include "maps/som/map_rows.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr double kLeastReach = 0x1p-1000;

}  // namespace

BatchEpoch::BatchEpoch(Som& som, const SumScales& scales, std::size_t threads, bool incomplete)
    : som_(som),
      threads_(threads),
      scales_(scales),
      sums_(som.elements().count() + 1, som.neurons()),
      known_(incomplete ? som.elements().count() : 0, incomplete ? som.neurons() : 0) {
  weights_to_change(som);  // before threads read them
}

namespace {

double longest_of_weights(const Som& som) {
  double longest = 0.0;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    double square = 0.0;
    for (std::size_t d = 0; d < som.elements().count(); ++d) {
      const double weight = som.weights()(neuron, d);
      square += weight * weight;
    }
    longest = std::max(longest, std::sqrt(square));
  }
  return longest;
}

// A bound on distances by a similarity of vectors whose lengths add to `lengths`: a Euclidean
// distance is at most this, others of `elements` elements exceed it by at most the root of their
// number, and a cosine distance is at most 2.
double greatest_distance(Similarity similarity, double lengths, std::size_t elements) {
  if (similarity == Similarity::kCosine) return 2.0;
  return lengths * std::sqrt(static_cast<double>(elements));
}

}  // namespace

void BatchEpoch::measure(double longest) {
  const SomParameters& parameters = som_.parameters();
  const double lengths = longest + longest_of_weights(som_);
  double greatest = 0.0;
  for (const Layer& layer : parameters.layers) {
    greatest += layer.weight / layer.scale.value_or(1.0) *
                greatest_distance(layer.similarity, lengths, layer.count);
  }
  if (parameters.layers.empty()) {
    greatest = greatest_distance(parameters.similarity, lengths, som_.elements().count());
  }
  distance_scale_ = scales_.scale_for(greatest);
}

// A missing element is as far away as none: the weight takes its place.
double BatchEpoch::distance(const SignalView& sample, std::size_t winner, std::vector<float>& row,
                            SomWorkspace& workspace) const {
  if (known_.rows() == 0) return som_.distance(sample, winner, workspace);
  row.assign(sample.values.begin(), sample.values.end());
  for (std::size_t d = 0; d < row.size(); ++d) {
    if (std::isnan(row[d])) row[d] = som_.weights()(winner, d);
  }
  return som_.distance(SignalView::dense(row), winner, workspace);
}

void BatchEpoch::add_distances(const Samples& samples, const std::vector<std::size_t>& winners) {
  std::vector<std::int64_t> integers(samples.count());
  for_each_range(samples.count(), threads_, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    std::vector<float> row;
    for (std::size_t i = begin; i < end; ++i) {
      integers[i] = static_cast<std::int64_t>(distance(samples[i], winners[i], row, workspace) *
                                              distance_scale_);
    }
  });
  for (const std::int64_t integer : integers) distances_ += integer;
}

double BatchEpoch::mean_distance(std::size_t samples) const {
  return static_cast<double>(distances_) / distance_scale_ / static_cast<double>(samples);
}

std::vector<std::size_t> BatchEpoch::add(const Samples& seen) {
  const bool incomplete = known_.rows() > 0;
  std::vector<std::size_t> winners =
      incomplete ? winners_by_known(som_, seen, threads_) : winners_of_seen(som_, seen, threads_);
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
                     if (incomplete) {
                       add_known(seen, winners, block);
                     } else {
                       add_block(seen, winners, block);
                     }
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

void BatchEpoch::add_known(const Samples& samples, const std::vector<std::size_t>& winners,
                           std::size_t block) {
  const std::size_t first = block * kDoubleLanes;
  const std::size_t end = std::min(first + kDoubleLanes, samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const std::span<const float> values = samples[i].values;
    for (std::size_t d = first; d < end; ++d) {
      if (std::isnan(values[d])) continue;
      sums_(d, winners[i]) += scales_.integer(d, values[d]);
      ++known_(d, winners[i]);
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

  // The numbers of samples that know the elements.
  std::span<const double> of_known(std::size_t block) {
    const std::int64_t* const known = epoch_.known_.data() + block * numbers_.size();
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = static_cast<double>(known[i]);
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

// The same, each element by the samples that know it.
void BatchEpoch::move_known(std::size_t block, std::span<const double> sums,
                            std::span<const double> totals) {
  const std::size_t first = block * kDoubleLanes;
  const std::size_t count = std::min(kDoubleLanes, som_.elements().count() - first);
  LaneMatrix<float>& weights = weights_to_change(som_);
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    for (std::size_t i = 0; i < count; ++i) {
      const double total = totals[neuron * kDoubleLanes + i];
      if (total < kLeastReach) continue;
      weights(neuron, first + i) = static_cast<float>(sums[neuron * kDoubleLanes + i] / total);
    }
  }
}

void BatchEpoch::finish(double radius) {
  const NeighbourhoodMixing mixing(som_.grid(), som_.parameters().neighbourhood, radius);
  const std::size_t elements = som_.elements().count();
  if (known_.rows() > 0) {
    for_each_range(known_.blocks(), threads_, [&](std::size_t begin, std::size_t end) {
      Means means(*this, mixing);
      Means known(*this, mixing);
      for (std::size_t block = begin; block < end; ++block) {
        move_known(block, means.of_block(block), known.of_known(block));
      }
    });
    return;
  }
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
