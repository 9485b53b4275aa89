#include "maps/reading/screening_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace somato {
namespace {

using kernels::Candidates;
using kernels::kBlockNeurons;
using kernels::kTileSamples;

constexpr std::size_t kRunTiles = 120;
constexpr std::size_t kRunSamples = kRunTiles * kTileSamples;
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// Looking at the means of fewer blocks, or screening more of them after all, costs more than it
// saves.
constexpr std::size_t kBlocksWorthSkipping = 32;
constexpr double kShareWorthSkipping = 0.7;

// All blocks, with neighbours far apart in the order: a good score is found early, and few later
// ones are better.
std::vector<std::uint32_t> scattered(std::size_t count) {
  constexpr double kGoldenSection = 0.618;
  std::vector<std::uint32_t> blocks(count);
  std::size_t step = 1 + static_cast<std::size_t>(kGoldenSection * static_cast<double>(count));
  while (std::gcd(step, count) != 1) ++step;
  for (std::size_t i = 0; i < count; ++i) {
    blocks[i] = static_cast<std::uint32_t>(i * step % count);
  }
  return blocks;
}

std::size_t tiles_for(std::size_t samples) {
  return (samples + kTileSamples - 1) / kTileSamples;
}

}  // namespace

ScreeningRun::ScreeningRun(const Som& som, const ScreenedMap& map, const Samples& samples, bool two,
                           bool skip)
    : som_(som),
      map_(map),
      samples_(samples),
      two_(two),
      skipping_(skip && som.parameters().similarity == Similarity::kEuclidean &&
                map.blocks() >= kBlocksWorthSkipping),
      all_blocks_(scattered(map.blocks())),
      integers_(kRunSamples * 2 * map.pairs()),
      factors_(kRunSamples),
      known_(kRunSamples),
      candidates_(kRunSamples),
      near_(map.blocks()) {
  if (!skipping_) return;
  arranged_.resize(integers_.size());
  mean_scores_.resize(kRunSamples * map.mean_blocks() * kBlockNeurons);
  places_.resize(map.mean_blocks() * kBlockNeurons);
  radii_.assign(map.radii().begin(), map.radii().end());
}

void ScreeningRun::find(std::size_t begin, std::span<Winners> found) {
  for (std::size_t i = 0; i < found.size(); i += kRunSamples) {
    find_some(begin + i, found.subspan(i, std::min(kRunSamples, found.size() - i)));
  }
}

void ScreeningRun::find_some(std::size_t begin, std::span<Winners> found) {
  begin_ = begin;
  for (std::size_t i = 0; i < found.size(); ++i) take(begin + i, i);
  const std::size_t tiles = tiles_for(found.size());
  for (std::size_t i = found.size(); i < tiles * kTileSamples; ++i) fill_up(i);
  if (skipping_) {
    score_means(tiles);
    arrange(found.size());
  }
  for (std::size_t i = 0; i < tiles * kTileSamples; ++i) start(i);
  if (skipping_) {
    screen_near(tiles);
  } else {
    screen_all(tiles);
  }
  for (std::size_t i = 0; i < found.size(); ++i) found[known_[i].sample - begin] = decide(i);
}

// The distance of a sample from the centre.
double ScreeningRun::length_of(const float* x) const {
  constexpr float kTooSmall = 1e-30F;  // for squares in single precision
  const auto& kernels = kernels::batch_table();
  const float* centre = map_.centre().data();
  const float squared = kernels.squared_length(x, centre, map_.columns());
  return std::sqrt(squared < kTooSmall ? kernels.squared_distance(x, centre, map_.columns())
                                       : double{squared});
}

void ScreeningRun::take(std::size_t sample, std::size_t i) {
  const float* x = samples_[sample].values.data();
  const auto& kernels = kernels::batch_table();
  const float* centre = map_.centre().data();
  const double length = length_of(x);
  const float rounded_off = kernels.to_integers(x, centre, ScreenedMap::integer_factor(length),
                                                map_.columns(), integers_of(i));
  known_[i] = {sample, length / map_.unit(), 0.0, map_.score_factor(length), 0};
  known_[i].error = map_.score_error(known_[i].distance, rounded_off);
}

// Up to a whole tile, by samples without candidates.
void ScreeningRun::fill_up(std::size_t i) {
  std::fill_n(integers_of(i), 2 * map_.pairs(), std::int16_t{0});
  known_[i] = {};
  known_[i].sample = samples_.count();
}

void ScreeningRun::start(std::size_t i) {
  const bool real = known_[i].sample < samples_.count();
  Candidates& candidates = candidates_[i];
  factors_[i] = known_[i].factor;
  candidates.threshold = real ? kInfinite : -kInfinite;
  candidates.margin = static_cast<float>(2.0 * known_[i].error * (1.0 + 0x1p-20));
  candidates.least = kInfinite;
  candidates.second_least = kInfinite;
  candidates.count = 0;
  candidates.overflown = false;
}

kernels::ScreenedTile ScreeningRun::tile(std::size_t number) {
  const std::size_t first = number * kTileSamples;
  return {integers_of(first), factors_.data() + first, candidates_.data() + first, two_};
}

// A few blocks for all tiles, then the next: the blocks stay in the nearest cache.
void ScreeningRun::screen_all(std::size_t tiles) {
  constexpr std::size_t kBlocks = 4;
  for (std::size_t block = 0; block < map_.blocks(); block += kBlocks) {
    const std::size_t count = std::min(kBlocks, map_.blocks() - block);
    for (std::size_t t = 0; t < tiles; ++t) {
      kernels::batch_table().screen(map_.neurons(), all_blocks_.data() + block, count, tile(t));
    }
  }
}

void ScreeningRun::score_means(std::size_t tiles) {
  for (std::size_t i = 0; i < tiles * kTileSamples; ++i) factors_[i] = known_[i].factor;
  for (std::size_t t = 0; t < tiles; ++t) {
    kernels::batch_table().score(map_.means(), map_.mean_blocks(), tile(t),
                                 mean_scores_of(t * kTileSamples));
  }
}

std::uint32_t ScreeningRun::nearest_block(std::size_t i) {
  const auto& kernels = kernels::batch_table();
  const float* scores = mean_scores_of(i);
  const float least = kernels.least(scores, map_.mean_blocks());
  kernels.places_up_to(scores, map_.mean_blocks(), least, places_.data());
  return places_.front();
}

// Puts the samples in the order of their nearest blocks.
void ScreeningRun::arrange(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) known_[i].nearest_block = nearest_block(i);
  std::sort(known_.begin(), known_.begin() + static_cast<std::ptrdiff_t>(count),
            [](const Known& a, const Known& b) {
              return a.nearest_block != b.nearest_block ? a.nearest_block < b.nearest_block
                                                        : a.sample < b.sample;
            });
  const std::size_t row = 2 * map_.pairs();
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(integers_of(known_[i].sample - begin_), row, arranged_.data() + i * row);
  }
  std::copy(integers_.begin() + static_cast<std::ptrdiff_t>(count * row), integers_.end(),
            arranged_.begin() + static_cast<std::ptrdiff_t>(count * row));
  integers_.swap(arranged_);
}

void ScreeningRun::screen_near(std::size_t tiles) {
  std::size_t screened = 0;
  for (std::size_t t = 0; t < tiles; ++t) screened += screen_tile(t);
  const auto all = static_cast<double>(tiles * map_.blocks());
  skipping_ = static_cast<double>(screened) < kShareWorthSkipping * all;
}

// The nearest blocks first, which bound the distance of the winner; then the blocks within this
// bound.
std::size_t ScreeningRun::screen_tile(std::size_t number) {
  const auto& kernels = kernels::batch_table();
  const std::size_t begin = number * kTileSamples;
  list_.clear();
  for (std::size_t i = begin; i < begin + kTileSamples; ++i) {
    if (known_[i].sample == samples_.count()) break;
    if (list_.empty() || list_.back() != known_[i].nearest_block) {
      list_.push_back(known_[i].nearest_block);
    }
  }
  kernels.screen(map_.neurons(), list_.data(), list_.size(), tile(number));
  std::fill(near_.begin(), near_.end(), 0);
  for (std::size_t i = begin; i < begin + kTileSamples; ++i) {
    if (known_[i].sample < samples_.count()) mark_near(i);
  }
  for (const std::uint32_t block : list_) near_[block] = 0;
  const std::size_t done = list_.size();
  list_.clear();
  for (std::uint32_t block = 0; block < near_.size(); ++block) {
    if (near_[block] != 0) list_.push_back(block);
  }
  kernels.screen(map_.neurons(), list_.data(), list_.size(), tile(number));
  return done + list_.size();
}

// Squared distances are 2 score + |x - centre|^2; all in units, with a margin for their errors.
void ScreeningRun::mark_near(std::size_t i) {
  const Known& known = known_[i];
  const Candidates& candidates = candidates_[i];
  const double from_centre = known.distance * known.distance;
  constexpr double kLanes = kBlockNeurons;
  const double of_length = (static_cast<double>(map_.columns()) / kLanes + 20.0) * 0x1p-23;
  const double room = 2.0 * known.error + of_length * (1.0 + from_centre);
  const auto best = double{two_ ? candidates.second_least : candidates.least};
  const double farthest = std::sqrt(std::max(0.0, 2.0 * best + from_centre + room));
  const auto reach = static_cast<float>(farthest * (1.0 + 0x1p-20) + 0x1p-20);
  const auto shift = static_cast<float>(from_centre - room);
  kernels::batch_table().mark_near(mean_scores_of(known.sample - begin_), radii_.data(),
                                   near_.size(), reach, shift, near_.data());
}

// The score in double precision, least for the winner.
double ScreeningRun::score(const float* x, std::size_t place) const {
  const auto& kernels = kernels::batch_table();
  const float* weights = map_.weights_at(place).data();
  return som_.parameters().similarity == Similarity::kEuclidean
             ? kernels.squared_distance(weights, x, map_.columns())
             : -kernels.inner_product(weights, x, map_.columns());
}

Winners ScreeningRun::decide(std::size_t i) {
  const Candidates& candidates = candidates_[i];
  const float* x = samples_[known_[i].sample].values.data();
  scored_.clear();
  for (const kernels::CandidateNeuron& candidate : std::span(candidates.kept, candidates.count)) {
    if (!(candidate.score < candidates.threshold)) continue;
    scored_.push_back({0.0, map_.neuron_at(candidate.place), candidate.place});
  }
  if (candidates.overflown || scored_.empty()) return decide_among_all(x);
  if (scored_.size() == 1) return {scored_.front().neuron, scored_.front().neuron};
  for (Scored& one : scored_) one.score = score(x, one.place);
  return best_of_scored();
}

Winners ScreeningRun::decide_among_all(const float* x) {
  scored_.clear();
  for (std::size_t place = 0; place < som_.neurons(); ++place) {
    scored_.push_back({score(x, place), map_.neuron_at(place), place});
  }
  return best_of_scored();
}

Winners ScreeningRun::best_of_scored() {
  const std::size_t wanted = std::min<std::size_t>(2, scored_.size());
  std::partial_sort(scored_.begin(), scored_.begin() + static_cast<std::ptrdiff_t>(wanted),
                    scored_.end());
  return {scored_[0].neuron, scored_[wanted - 1].neuron};
}

}  // namespace somato
