#include "maps/analysis/rank_measures.h"

#include <limits>
#include <utility>

#include "base/core/threads.h"
#include "maps/analysis/grid_distances.h"
#include "maps/analysis/row_distances.h"
#include "somato/core/check.h"

namespace somato {
namespace {

double real_of(std::size_t count) {
  return static_cast<double>(count);
}

// The expected rank of a sample among the others by their distances, when equal distances are in a
// random order.
struct ExpectedRank {
  double inside = 0.0;  // the probability that it is among the k nearest
  double beyond = 0.0;  // the mean of max(0, rank - k)
};

// Samples with the ranks first + 1 to last.
ExpectedRank of_ties(std::size_t first, std::size_t last, std::size_t k) {
  if (last <= k) return {1.0, 0.0};
  if (first >= k) return {0.0, 0.5 * real_of(first + 1 + last) - real_of(k)};
  const double past = real_of(last - k);
  const double ties = real_of(last - first);
  return {real_of(k - first) / ties, 0.5 * past * (past + 1.0) / ties};
}

// The ranks of the samples by their distances from `sample`, which gets none.
std::vector<ExpectedRank> expected_ranks(const std::vector<double>& distances, std::size_t sample,
                                         std::size_t k) {
  const std::vector<std::size_t> order = others_by_distance(distances, sample);
  std::vector<ExpectedRank> ranks(distances.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && distances[order[last]] == distances[order[first]]) ++last;
    const ExpectedRank rank = of_ties(first, last, k);
    for (; first < last; ++first) ranks[order[first]] = rank;
  }
  return ranks;
}

// Sums over the other samples: those of RankMeasures before they are scaled.
RankMeasures compare_ranks(const std::vector<ExpectedRank>& in_input,
                           const std::vector<ExpectedRank>& on_map) {
  RankMeasures sums;
  for (std::size_t j = 0; j < on_map.size(); ++j) {
    sums.trustworthiness += on_map[j].inside * in_input[j].beyond;
    sums.continuity += in_input[j].inside * on_map[j].beyond;
    sums.neighbourhood_preservation += in_input[j].inside * on_map[j].inside;
  }
  return sums;
}

RankMeasures scaled(const std::vector<RankMeasures>& sums, std::size_t k) {
  RankMeasures total;
  for (const RankMeasures& sum : sums) {
    total.trustworthiness += sum.trustworthiness;
    total.continuity += sum.continuity;
    total.neighbourhood_preservation += sum.neighbourhood_preservation;
  }
  const double n = real_of(sums.size());
  const double pairs = n * real_of(k);
  const double most = 0.5 * pairs * (2.0 * n - 3.0 * real_of(k) - 1.0);
  return {1.0 - total.trustworthiness / most, 1.0 - total.continuity / most,
          total.neighbourhood_preservation / pairs};
}

}  // namespace

RankMeasures measure_ranks(const Som& som, const Samples& samples,
                           const std::vector<std::size_t>& winners, std::size_t neighbours,
                           std::size_t threads) {
  require(winners.size() == samples.count(), "measure_ranks: each sample needs a winner");
  constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = samples.count();
  if (neighbours == 0 || count <= 2 * neighbours) return {kUndefined, kUndefined, kUndefined};
  const RowDistances inputs = RowDistances::of_samples(som, samples);
  std::vector<RankMeasures> sums(count);
  for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> distances(count);
    for (std::size_t i = begin; i < end; ++i) {
      inputs.write_from(i, distances);
      const std::vector<ExpectedRank> in_input = expected_ranks(distances, i, neighbours);
      const std::vector<double> squares = squared_grid_distances(som.grid(), winners[i]);
      for (std::size_t j = 0; j < count; ++j) distances[j] = squares[winners[j]];
      sums[i] = compare_ranks(in_input, expected_ranks(distances, i, neighbours));
    }
  });
  return scaled(sums, neighbours);
}

}  // namespace somato
