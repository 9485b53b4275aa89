#include "maps/analysis/ward.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "somato/core/random.h"

namespace somato {
namespace {

WeightedPoints weighted_random_points(std::size_t count, std::size_t size, Random& random) {
  WeightedPoints points{Matrix<double>(count, size), {}};
  for (double& value : points.rows.values()) value = random.normal();
  for (std::size_t i = 0; i < count; ++i) {
    points.weights.push_back(static_cast<double>(1 + random.below(4)));
  }
  return points;
}

using Members = std::set<std::size_t>;

// The sum of squared distances from the mean.
double spread_of(const WeightedPoints& points, const Members& members) {
  double weight = 0.0;
  std::vector<double> mean(points.rows.columns());
  for (const std::size_t i : members) {
    weight += points.weights[i];
    for (std::size_t d = 0; d < mean.size(); ++d) mean[d] += points.weights[i] * points.rows(i, d);
  }
  for (double& value : mean) value /= weight;
  double sum = 0.0;
  for (const std::size_t i : members) {
    for (std::size_t d = 0; d < mean.size(); ++d) {
      sum += points.weights[i] * std::pow(points.rows(i, d) - mean[d], 2);
    }
  }
  return sum;
}

using PointEdges = std::vector<std::vector<std::size_t>>;

bool touch(const PointEdges& edges, const Members& a, const Members& b) {
  return std::any_of(a.begin(), a.end(), [&](std::size_t i) {
    return std::any_of(edges[i].begin(), edges[i].end(),
                       [&](std::size_t j) { return b.contains(j); });
  });
}

// Ward's definition: the pair whose union increases the spread least, among those that touch.
std::vector<ClusterMerge> merges_by_definition(const WeightedPoints& points,
                                               const PointEdges* edges) {
  std::vector<std::pair<std::size_t, Members>> clusters;
  for (std::size_t i = 0; i < points.count(); ++i) clusters.push_back({i, {i}});
  std::vector<ClusterMerge> merges;
  while (clusters.size() > 1) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t a = 0;
    std::size_t b = 0;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        if (edges && !touch(*edges, clusters[i].second, clusters[j].second)) continue;
        Members both = clusters[i].second;
        both.insert(clusters[j].second.begin(), clusters[j].second.end());
        const double increase = spread_of(points, both) - spread_of(points, clusters[i].second) -
                                spread_of(points, clusters[j].second);
        if (increase >= least) continue;
        least = increase;
        a = i;
        b = j;
      }
    }
    Members both = clusters[a].second;
    both.insert(clusters[b].second.begin(), clusters[b].second.end());
    const auto [low, high] = std::minmax({clusters[a].first, clusters[b].first});
    merges.push_back({low, high, std::sqrt(2 * least), both.size()});
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(b));
    clusters[a] = {points.count() + merges.size() - 1, both};
  }
  return merges;
}

void expect_equal(const std::vector<ClusterMerge>& found,
                  const std::vector<ClusterMerge>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].first, expected[i].first) << i;
    EXPECT_EQ(found[i].second, expected[i].second) << i;
    EXPECT_EQ(found[i].neurons, expected[i].neurons) << i;
    EXPECT_NEAR(found[i].height, expected[i].height, 1e-9) << i;
  }
}

TEST(Ward, MergesWhatIncreasesTheSpreadLeast) {
  Random random(21);
  for (int trial = 0; trial < 5; ++trial) {
    const WeightedPoints points = weighted_random_points(25, 3, random);
    expect_equal(ward_merges(points), merges_by_definition(points, nullptr));
  }
}

TEST(Ward, MayBeRestrictedToNeighbours) {
  Random random(22);
  PointEdges edges(24);  // 4 x 6
  for (std::size_t i = 0; i < 24; ++i) {
    if (i % 6 > 0) edges[i].push_back(i - 1);
    if (i % 6 < 5) edges[i].push_back(i + 1);
    if (i >= 6) edges[i].push_back(i - 6);
    if (i < 18) edges[i].push_back(i + 6);
  }
  for (int trial = 0; trial < 5; ++trial) {
    const WeightedPoints points = weighted_random_points(24, 2, random);
    expect_equal(connected_ward_merges(points, edges), merges_by_definition(points, &edges));
  }
}

TEST(Ward, MergesPartsWithoutAnEdgeLast) {
  const WeightedPoints points{Matrix<double>(4, 1, {0, 9, 1, 30}), {1, 1, 1, 1}};
  const std::vector<ClusterMerge> merges = connected_ward_merges(points, {{1}, {0}, {3}, {2}});
  ASSERT_EQ(merges.size(), 3U);
  EXPECT_EQ(merges[0], (ClusterMerge{0, 1, 9.0, 2}));
  EXPECT_EQ(merges[1], (ClusterMerge{2, 3, 29.0, 2}));
  EXPECT_EQ(merges[2].neurons, 4U);
}

TEST(Ward, OfEqualPointsHasHeightsOfZeroAndOnePointHasNoMerges) {
  const WeightedPoints points{Matrix<double>(5, 2, 3.0), std::vector<double>(5, 1.0)};
  const std::vector<ClusterMerge> merges = ward_merges(points);
  ASSERT_EQ(merges.size(), 4U);
  for (const ClusterMerge& merge : merges) EXPECT_EQ(merge.height, 0.0);
  EXPECT_EQ(merges.back().neurons, 5U);
  EXPECT_TRUE(ward_merges({Matrix<double>(1, 2), {1.0}}).empty());
}

}  // namespace
}  // namespace somato
