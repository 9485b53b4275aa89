#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/kernels/batch_kernels.h"
#include "maps/reading/screened_map.h"
#include "somato/core/matrix.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The search of one thread for the winners of dense samples, a few hundred at a time.
///
/// If samples are far from most of the map (data with clusters), whole blocks of neurons are
/// skipped: with the mean m of a block's weights and the greatest distance r of any of them from m,
/// a sample at distance d from m is at least d - r away from all. Samples are then processed in the
/// order of their nearest blocks, so that those of a tile require the same ones. If this skips too
/// few blocks, it is disabled.
class ScreeningRun {
 public:
  /// Refers to all of them. With `two`, looks for the two most similar neurons; without `skip`,
  /// leaves no blocks out.
  ScreeningRun(const Som& som, const ScreenedMap& map, const Samples& samples, bool two,
               bool skip = true);

  /// Finds the winners of samples begin, begin + 1, ..., one for each place of `found`.
  void find(std::size_t begin, std::span<Winners> found);

 private:
  // A sample as integers, with its bounds.
  struct Known {
    std::size_t sample = 0;
    double distance = 0.0;  // from the centre, in units
    double error = 0.0;     // of its scores
    float factor = 0.0F;
    std::uint32_t nearest_block = 0;
  };
  struct Scored {
    double score;
    std::size_t neuron;
    std::size_t place;
    bool operator<(const Scored& other) const {
      return score != other.score ? score < other.score : neuron < other.neuron;
    }
  };

  void find_some(std::size_t begin, std::span<Winners> found);
  double length_of(const float* x) const;
  void take(std::size_t sample, std::size_t i);
  void fill_up(std::size_t i);
  void start(std::size_t i);
  kernels::ScreenedTile tile(std::size_t number);
  std::int16_t* integers_of(std::size_t i) { return integers_.data() + i * 2 * map_.pairs(); }
  float* mean_scores_of(std::size_t place) {
    return mean_scores_.data() + place * map_.mean_blocks() * kernels::kBlockNeurons;
  }

  void screen_all(std::size_t tiles);
  void screen_near(std::size_t tiles);
  void score_means(std::size_t tiles);
  std::uint32_t nearest_block(std::size_t i);
  void arrange(std::size_t count);
  std::size_t screen_tile(std::size_t number);
  void mark_near(std::size_t i);

  double score(const float* x, std::size_t place) const;
  Winners decide(std::size_t i);
  Winners decide_among_all(const float* x);
  Winners best_of_scored();

  const Som& som_;
  const ScreenedMap& map_;
  const Samples& samples_;
  bool two_;
  bool skipping_;
  std::size_t begin_ = 0;  // the first sample at hand
  std::vector<std::uint32_t> all_blocks_;
  AlignedVector<std::int16_t> integers_;
  AlignedVector<std::int16_t> arranged_;
  std::vector<float> factors_;
  std::vector<Known> known_;
  std::vector<kernels::Candidates> candidates_;
  AlignedVector<float> mean_scores_;  // by the place a sample had before they were arranged
  std::vector<float> radii_;
  std::vector<std::int32_t> near_;  // 1 where a sample of the tile may find its winner
  std::vector<std::uint32_t> list_;
  std::vector<std::uint32_t> places_;
  std::vector<Scored> scored_;
};

}  // namespace somato
