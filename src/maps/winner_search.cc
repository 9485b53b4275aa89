#include "maps/winner_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/batch_kernels.h"
#include "somato/core/check.h"
#include "somato/core/threads.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using kernels::Candidates;
using kernels::kBlockNeurons;
using kernels::kTileSamples;

constexpr std::size_t kRunTiles = 40;
constexpr std::size_t kRunSamples = kRunTiles * kTileSamples;
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// All blocks, neighbours far apart from each other: so a good score is soon met, and few after it
// are better still.
void scatter(std::vector<std::uint32_t>& blocks) {
  constexpr double kGoldenSection = 0.618;
  std::size_t step =
      1 + static_cast<std::size_t>(kGoldenSection * static_cast<double>(blocks.size()));
  while (std::gcd(step, blocks.size()) != 1) ++step;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    blocks[i] = static_cast<std::uint32_t>(i * step % blocks.size());
  }
}

// A sample as integers, and what is known of it.
struct Known {
  double distance = 0.0;  // from the centre, in units
  double error = 0.0;     // of its scores
  float factor = 0.0F;
};

}  // namespace

// Samples that are screened one after the other by one thread: scratch memory.
class WinnerSearch::Run {
 public:
  Run(const WinnerSearch& search, const Samples& samples, bool two)
      : som_(search.som_),
        map_(search.map_),
        samples_(samples),
        two_(two),
        all_blocks_(map_.blocks()),
        integers_(kRunSamples * 2 * map_.pairs()),
        factors_(kRunSamples),
        known_(kRunSamples),
        candidates_(kRunSamples) {
    scatter(all_blocks_);
  }

  // At most kRunSamples of them.
  void find(std::size_t begin, std::span<Winners> found) {
    for (std::size_t i = 0; i < found.size(); ++i) take(begin + i, i);
    const std::size_t tiles = (found.size() + kTileSamples - 1) / kTileSamples;
    for (std::size_t i = found.size(); i < tiles * kTileSamples; ++i) take_nothing(i);
    screen(tiles);
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = decide(begin + i, i);
  }

 private:
  std::int16_t* integers_of(std::size_t i) { return integers_.data() + i * 2 * map_.pairs(); }

  void take(std::size_t sample, std::size_t i) {
    const float* x = samples_[sample].values.data();
    const auto& kernels = kernels::batch_table();
    const double length =
        std::sqrt(kernels.squared_distance(x, map_.centre().data(), map_.columns()));
    const float rounded_off =
        kernels.to_integers(x, map_.centre().data(), ScreenedMap::integer_factor(length),
                            map_.columns(), integers_of(i));
    factors_[i] = map_.score_factor(length);
    known_[i].distance = length / map_.unit();
    known_[i].error = map_.score_error(known_[i].distance, rounded_off);
    const auto margin = static_cast<float>(2.0 * known_[i].error * (1.0 + 0x1p-20));
    start(candidates_[i], kInfinite, margin);
  }

  // Fills a tile up.
  void take_nothing(std::size_t i) {
    std::fill_n(integers_of(i), 2 * map_.pairs(), std::int16_t{0});
    factors_[i] = 0.0F;
    start(candidates_[i], -kInfinite, 0.0F);
  }

  static void start(Candidates& candidates, float threshold, float margin) {
    candidates.threshold = threshold;
    candidates.margin = margin;
    candidates.least = kInfinite;
    candidates.second_least = kInfinite;
    candidates.count = 0;
    candidates.overflown = false;
  }

  kernels::ScreenedTile tile(std::size_t number) {
    const std::size_t first = number * kTileSamples;
    return {integers_of(first), factors_.data() + first, candidates_.data() + first, two_};
  }

  // A few blocks for all tiles, then the next: the blocks stay in the nearest cache.
  void screen(std::size_t tiles) {
    constexpr std::size_t kBlocks = 4;
    for (std::size_t block = 0; block < map_.blocks(); block += kBlocks) {
      const std::size_t count = std::min(kBlocks, map_.blocks() - block);
      for (std::size_t t = 0; t < tiles; ++t) {
        kernels::batch_table().screen(map_.neurons(), all_blocks_.data() + block, count, tile(t));
      }
    }
  }

  // The score in double precision, least for the winner.
  double score(const float* x, std::size_t place) const {
    const auto& kernels = kernels::batch_table();
    const float* weights = map_.weights_at(place).data();
    return som_.parameters().similarity == Similarity::kEuclidean
               ? kernels.squared_distance(weights, x, map_.columns())
               : -kernels.inner_product(weights, x, map_.columns());
  }

  Winners decide(std::size_t sample, std::size_t i) {
    const Candidates& candidates = candidates_[i];
    if (candidates.overflown) return decide_among_all(sample);
    scored_.clear();
    for (std::uint32_t k = 0; k < candidates.count; ++k) {
      if (!(candidates.kept[k].score < candidates.threshold)) continue;
      scored_.push_back({0.0, map_.neuron_at(candidates.kept[k].place), candidates.kept[k].place});
    }
    if (scored_.size() == 1) return {scored_.front().neuron, scored_.front().neuron};
    const float* x = samples_[sample].values.data();
    for (Scored& one : scored_) one.score = score(x, one.place);
    return best_of_scored();
  }

  Winners decide_among_all(std::size_t sample) {
    const float* x = samples_[sample].values.data();
    scored_.clear();
    for (std::size_t place = 0; place < som_.neurons(); ++place) {
      scored_.push_back({score(x, place), map_.neuron_at(place), place});
    }
    return best_of_scored();
  }

  Winners best_of_scored() {
    const std::size_t wanted = std::min<std::size_t>(2, scored_.size());
    std::partial_sort(scored_.begin(), scored_.begin() + static_cast<std::ptrdiff_t>(wanted),
                      scored_.end());
    return {scored_[0].neuron, scored_[wanted - 1].neuron};
  }

  struct Scored {
    double score;
    std::size_t neuron;
    std::size_t place;
    bool operator<(const Scored& other) const {
      return score != other.score ? score < other.score : neuron < other.neuron;
    }
  };

  const Som& som_;
  const ScreenedMap& map_;
  const Samples& samples_;
  bool two_;
  std::vector<std::uint32_t> all_blocks_;
  AlignedVector<std::int16_t> integers_;
  std::vector<float> factors_;
  std::vector<Known> known_;
  std::vector<Candidates> candidates_;
  std::vector<Scored> scored_;
};

WinnerSearch::WinnerSearch(const Som& som, std::size_t threads) : som_(som), map_(som, threads) {}

bool WinnerSearch::pays(const Som& som, const Samples& samples) {
  constexpr std::size_t kFewNeurons = 32;
  constexpr std::size_t kFewSamples = 64;
  return !samples.is_sparse() && samples.count() >= kFewSamples && som.neurons() >= kFewNeurons;
}

std::vector<Winners> WinnerSearch::find_all(const Som& som, const Samples& seen, bool two,
                                            std::size_t threads) {
  std::vector<Winners> found(seen.count());
  if (pays(som, seen)) {
    const WinnerSearch search(som, threads);
    for_each_range(seen.count(), threads, [&](std::size_t begin, std::size_t end) {
      search.find(seen, begin, two, std::span(found).subspan(begin, end - begin));
    });
    return found;
  }
  for_each_range(seen.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    AlignedVector<float> dense(seen.size());
    for (std::size_t i = begin; i < end; ++i) {
      write_dense(seen[i], dense);
      found[i] = som.best_of(dense, two, workspace);
    }
  });
  return found;
}

void WinnerSearch::find(const Samples& samples, std::size_t begin, bool two,
                        std::span<Winners> found) const {
  if (map_.all_alike()) {
    std::fill(found.begin(), found.end(),
              Winners{0, som_.neurons() > 1 ? std::size_t{1} : std::size_t{0}});
    return;
  }
  Run run(*this, samples, two);
  for (std::size_t i = 0; i < found.size(); i += kRunSamples) {
    run.find(begin + i, found.subspan(i, std::min(kRunSamples, found.size() - i)));
  }
}

const Samples& seen_samples(const Som& som, const Samples& samples, Samples& storage) {
  require(samples.size() == som.input_size(),
          "the samples' size differs from the map's input size");
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the caller keeps both alive
  if (som.elements().all()) return prepared;
  storage = som.elements().gather(prepared);
  return storage;
}

std::vector<std::size_t> winners_of_seen(const Som& som, const Samples& seen, std::size_t threads) {
  std::vector<std::size_t> winners;
  winners.reserve(seen.count());
  for (const Winners& found : WinnerSearch::find_all(som, seen, false, threads)) {
    winners.push_back(found.first);
  }
  return winners;
}

}  // namespace somato
