#include "maps/analysis/watershed.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "maps/analysis/weighted_points.h"

namespace somato {
namespace {

using Vertices = std::vector<std::size_t>;
constexpr std::size_t kNoBasin = std::numeric_limits<std::size_t>::max();

// A flood that rises from the lowest vertex to the highest.
class Flood {
 public:
  Flood(const std::vector<double>& heights, const std::vector<Vertices>& neighbours)
      : heights_(heights), neighbours_(neighbours), basin_(heights.size(), kNoBasin) {}

  std::vector<std::size_t> rise() {
    Vertices order(heights_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(heights_[a], a) < std::tie(heights_[b], b);
    });
    for (std::size_t first = 0; first < order.size();) {
      std::size_t last = first;
      while (last < order.size() && heights_[order[last]] == heights_[order[first]]) ++last;
      reach({order.begin() + static_cast<std::ptrdiff_t>(first),
             order.begin() + static_cast<std::ptrdiff_t>(last)});
      first = last;
    }
    return basin_;
  }

 private:
  // All vertices of one height: first those beside basins, then those beside these, and so on; what
  // is left are new basins.
  void reach(Vertices level) {
    while (!level.empty()) {
      Vertices left;
      std::vector<std::pair<std::size_t, std::size_t>> reached;
      for (const std::size_t vertex : level) {
        const std::size_t from = lowest_flooded(vertex);
        if (from == kNoBasin) {
          left.push_back(vertex);
        } else {
          reached.emplace_back(vertex, basin_[from]);
        }
      }
      for (const auto& [vertex, basin] : reached) basin_[vertex] = basin;
      if (reached.empty()) basin_[left.front()] = left.front();
      if (reached.empty()) left.erase(left.begin());
      level = std::move(left);
    }
  }

  std::size_t lowest_flooded(std::size_t vertex) const {
    std::size_t lowest = kNoBasin;
    for (const std::size_t other : neighbours_[vertex]) {
      if (basin_[other] == kNoBasin) continue;
      if (lowest == kNoBasin ||
          std::tie(heights_[other], other) < std::tie(heights_[lowest], lowest)) {
        lowest = other;
      }
    }
    return lowest;
  }

  const std::vector<double>& heights_;
  const std::vector<Vertices>& neighbours_;
  std::vector<std::size_t> basin_;  // the first vertex of each, which is among its lowest
};

// The lowest pass from one basin into another.
struct Pass {
  double height = std::numeric_limits<double>::infinity();
  std::size_t into = kNoBasin;
};

std::map<std::size_t, Pass> lowest_passes(const std::vector<double>& heights,
                                          const std::vector<Vertices>& neighbours,
                                          const std::vector<std::size_t>& basins) {
  std::map<std::size_t, Pass> passes;
  for (std::size_t a = 0; a < basins.size(); ++a) {
    for (const std::size_t b : neighbours[a]) {
      if (basins[a] == basins[b]) continue;
      Pass& pass = passes[basins[a]];
      const double height = std::max(heights[a], heights[b]);
      if (std::tie(height, basins[b]) < std::tie(pass.height, pass.into)) {
        pass = {height, basins[b]};
      }
    }
  }
  return passes;
}

// Fills the shallowest basin; returns false if no two basins are connected.
bool fill_shallowest(const std::vector<double>& heights, const std::vector<Vertices>& neighbours,
                     std::vector<std::size_t>& basins) {
  std::size_t shallowest = kNoBasin;
  double least = std::numeric_limits<double>::infinity();
  const std::map<std::size_t, Pass> passes = lowest_passes(heights, neighbours, basins);
  for (const auto& [basin, pass] : passes) {
    const double depth = pass.height - heights[basin];
    if (depth >= least) continue;
    least = depth;
    shallowest = basin;
  }
  if (shallowest == kNoBasin) return false;
  const std::size_t other = passes.at(shallowest).into;
  // A basin has the number of its lowest vertex.
  const bool is_lower = std::tie(heights[shallowest], shallowest) < std::tie(heights[other], other);
  const auto [kept, filled] =
      is_lower ? std::pair(shallowest, other) : std::pair(other, shallowest);
  std::replace(basins.begin(), basins.end(), filled, kept);
  return true;
}

}  // namespace

std::vector<std::size_t> basins(const std::vector<double>& heights,
                                const std::vector<std::vector<std::size_t>>& neighbours,
                                std::optional<std::size_t> count) {
  std::vector<std::size_t> basins = Flood(heights, neighbours).rise();
  Vertices numbers = basins;
  std::sort(numbers.begin(), numbers.end());
  auto left =
      static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
  while (count && left > *count && fill_shallowest(heights, neighbours, basins)) --left;
  return numbered_in_order(basins);
}

}  // namespace somato
