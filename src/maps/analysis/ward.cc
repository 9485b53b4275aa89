#include "maps/analysis/ward.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace somato {
namespace {

// Clusters as they are merged: the means and weights of those that exist. A merged cluster takes
// the place of one of its parts.
class WardClusters {
 public:
  explicit WardClusters(const WeightedPoints& points)
      : means_(points.rows), weights_(points.weights), sizes_(points.count(), 1) {}

  double height(std::size_t a, std::size_t b) const {
    const double factor = 2.0 * weights_[a] * weights_[b] / (weights_[a] + weights_[b]);
    return std::sqrt(factor * squared_distance(means_.row(a), means_.row(b)));
  }

  // Merges a into b.
  void merge(std::size_t a, std::size_t b) {
    const double weight = weights_[a] + weights_[b];
    for (std::size_t d = 0; d < means_.columns(); ++d) {
      means_(b, d) = (weights_[a] * means_(a, d) + weights_[b] * means_(b, d)) / weight;
    }
    weights_[b] = weight;
    sizes_[b] += sizes_[a];
    sizes_[a] = 0;
  }

  std::size_t size(std::size_t a) const { return sizes_[a]; }
  bool exists(std::size_t a) const { return sizes_[a] > 0; }

 private:
  Matrix<double> means_;
  std::vector<double> weights_;
  std::vector<std::size_t> sizes_;
};

// A merge of the clusters that contain two points.
struct PointMerge {
  std::size_t a = 0;
  std::size_t b = 0;
  double height = 0.0;
};

// The representatives of points under merges, with the number of each cluster.
class MergedPoints {
 public:
  explicit MergedPoints(std::size_t points) : parent_(points), number_(points), size_(points, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    std::iota(number_.begin(), number_.end(), std::size_t{0});
  }

  ClusterMerge merge(const PointMerge& of, std::size_t number) {
    const std::size_t a = root(of.a);
    const std::size_t b = root(of.b);
    const auto [low, high] = std::minmax({number_[a], number_[b]});
    const ClusterMerge merged{low, high, of.height, size_[a] + size_[b]};
    parent_[a] = b;
    number_[b] = number;
    size_[b] = merged.neurons;
    return merged;
  }

 private:
  std::size_t root(std::size_t point) {
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }

  std::vector<std::size_t> parent_;
  std::vector<std::size_t> number_;
  std::vector<std::size_t> size_;
};

std::vector<ClusterMerge> with_numbers(const std::vector<PointMerge>& merges, std::size_t points) {
  MergedPoints merged(points);
  std::vector<ClusterMerge> numbered;
  numbered.reserve(merges.size());
  for (const PointMerge& merge : merges) {
    numbered.push_back(merged.merge(merge, points + numbered.size()));
  }
  return numbered;
}

// The nearest existing cluster; in a tie `preferred`, else the lowest.
std::pair<std::size_t, double> nearest_cluster(const WardClusters& clusters, std::size_t count,
                                               std::size_t from, std::size_t preferred) {
  std::size_t nearest = preferred;
  double least = preferred < count ? clusters.height(from, preferred)
                                   : std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < count; ++other) {
    if (other == from || !clusters.exists(other)) continue;
    const double height = clusters.height(from, other);
    if (height < least || nearest >= count) {
      least = height;
      nearest = other;
    }
  }
  return {nearest, least};
}

// Chains of nearest neighbours, which end in pairs that are nearest to each other: Ward's distance
// to a third cluster never falls by their merge (Murtagh, A survey of recent advances in
// hierarchical clustering algorithms, The Computer Journal 26, 1983).
std::vector<PointMerge> merges_by_chains(const WeightedPoints& points) {
  WardClusters clusters(points);
  std::vector<PointMerge> merges;
  std::vector<std::size_t> chain;
  std::size_t first = 0;
  while (merges.size() + 1 < points.count()) {
    while (chain.empty() && !clusters.exists(first)) ++first;
    if (chain.empty()) chain.push_back(first);
    const std::size_t before = chain.size() > 1 ? chain[chain.size() - 2] : points.count();
    const auto [nearest, height] = nearest_cluster(clusters, points.count(), chain.back(), before);
    if (nearest != before) {
      chain.push_back(nearest);
      continue;
    }
    merges.push_back({chain.back(), before, height});
    clusters.merge(std::max(chain.back(), before), std::min(chain.back(), before));
    chain.resize(chain.size() - 2);
  }
  return merges;
}

// A pair that may be merged; it is outdated once one of the two has changed.
struct CandidatePair {
  double height;
  std::size_t a;
  std::size_t b;
  std::size_t sizes;  // of both together

  bool operator>(const CandidatePair& other) const {
    return std::tie(height, a, b) > std::tie(other.height, other.a, other.b);
  }
};

// The clusters and their neighbours during connected merges.
class ConnectedWard {
 public:
  ConnectedWard(const WeightedPoints& points,
                const std::vector<std::vector<std::size_t>>& neighbours)
      : clusters_(points), neighbours_(points.count()) {
    for (std::size_t a = 0; a < neighbours.size(); ++a) {
      for (const std::size_t b : neighbours[a]) connect(a, b);
    }
  }

  std::vector<PointMerge> merge_all() {
    std::vector<PointMerge> merges;
    while (merges.size() + 1 < neighbours_.size()) {
      if (pairs_.empty()) connect_all();
      const CandidatePair pair = pairs_.top();
      pairs_.pop();
      if (!clusters_.exists(pair.a) || !clusters_.exists(pair.b)) continue;
      if (clusters_.size(pair.a) + clusters_.size(pair.b) != pair.sizes) continue;
      merges.push_back({pair.a, pair.b, pair.height});
      merge(pair.b, pair.a);
    }
    return merges;
  }

 private:
  void connect(std::size_t a, std::size_t b) {
    if (a == b || !neighbours_[a].insert(b).second) return;
    neighbours_[b].insert(a);
    add_pair(a, b);
  }

  void add_pair(std::size_t a, std::size_t b) {
    pairs_.push({clusters_.height(a, b), std::min(a, b), std::max(a, b),
                 clusters_.size(a) + clusters_.size(b)});
  }

  void merge(std::size_t a, std::size_t into) {
    clusters_.merge(a, into);
    for (const std::size_t other : neighbours_[a]) {
      neighbours_[other].erase(a);
      if (other == into) continue;
      neighbours_[other].insert(into);
      neighbours_[into].insert(other);
    }
    neighbours_[a].clear();
    for (const std::size_t other : neighbours_[into]) add_pair(other, into);
  }

  // Parts that share no edge become neighbours of each other when nothing else is left to merge.
  void connect_all() {
    std::vector<std::size_t> left;
    for (std::size_t a = 0; a < neighbours_.size(); ++a) {
      if (clusters_.exists(a)) left.push_back(a);
    }
    for (const std::size_t a : left) {
      for (const std::size_t b : left) connect(a, b);
    }
  }

  WardClusters clusters_;
  std::vector<std::set<std::size_t>> neighbours_;
  std::priority_queue<CandidatePair, std::vector<CandidatePair>, std::greater<>> pairs_;
};

}  // namespace

std::vector<ClusterMerge> ward_merges(const WeightedPoints& points) {
  std::vector<PointMerge> merges = merges_by_chains(points);
  // Chains give a merge after those of its parts, so that order is kept among equal heights.
  std::vector<std::size_t> order(merges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(merges[a].height, a) < std::tie(merges[b].height, b);
  });
  std::vector<PointMerge> sorted;
  sorted.reserve(merges.size());
  for (const std::size_t i : order) sorted.push_back(merges[i]);
  return with_numbers(sorted, points.count());
}

std::vector<ClusterMerge> connected_ward_merges(
    const WeightedPoints& points, const std::vector<std::vector<std::size_t>>& neighbours) {
  return with_numbers(ConnectedWard(points, neighbours).merge_all(), points.count());
}

}  // namespace somato
