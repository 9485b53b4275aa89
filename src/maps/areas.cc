#include "somato/maps/areas.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "somato/core/check.h"

namespace somato {
namespace {

// The class with most samples among the winners nearest to `neuron`.
std::size_t nearest_class(const Grid& grid, std::size_t neuron,
                          const std::vector<std::size_t>& winners,
                          const std::vector<std::size_t>& classes) {
  constexpr double kTolerance = 1e-9;  // equal distances on a hexagonal grid differ by rounding
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t winner : winners) {
    least = std::min(least, grid.squared_distance(neuron, winner));
  }
  std::map<std::size_t, std::size_t> samples_of_class;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (grid.squared_distance(neuron, winners[i]) <= least + kTolerance) {
      ++samples_of_class[classes[i]];
    }
  }
  return std::max_element(samples_of_class.begin(), samples_of_class.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// Marks all neurons of one area that can be reached from `start`.
void visit_region(const Grid& grid, const std::vector<std::size_t>& area_of_neuron,
                  std::size_t start, std::vector<bool>& visited) {
  std::vector<std::size_t> to_visit{start};
  visited[start] = true;
  while (!to_visit.empty()) {
    const std::size_t neuron = to_visit.back();
    to_visit.pop_back();
    for (const std::size_t other : grid.neighbours(neuron)) {
      if (visited[other] || area_of_neuron[other] != area_of_neuron[start]) continue;
      visited[other] = true;
      to_visit.push_back(other);
    }
  }
}

}  // namespace

std::vector<std::size_t> areas(const Grid& grid, const std::vector<std::size_t>& winners,
                               const std::vector<std::size_t>& classes) {
  require(winners.size() == classes.size(), "areas need a class for each winner");
  require(!winners.empty(), "areas need at least one winner");
  std::vector<std::size_t> area_of_neuron(grid.size());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    area_of_neuron[neuron] = nearest_class(grid, neuron, winners, classes);
  }
  return area_of_neuron;
}

bool areas_connected(const Grid& grid, const std::vector<std::size_t>& area_of_neuron) {
  std::vector<bool> visited(grid.size());
  std::set<std::size_t> seen;
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    if (visited[neuron]) continue;
    if (!seen.insert(area_of_neuron[neuron]).second) return false;
    visit_region(grid, area_of_neuron, neuron, visited);
  }
  return true;
}

bool classes_connected(const Grid& grid, const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& classes) {
  const std::vector<std::size_t> area_of_neuron = areas(grid, winners, classes);
  const std::set<std::size_t> with_area(area_of_neuron.begin(), area_of_neuron.end());
  const std::set<std::size_t> with_samples(classes.begin(), classes.end());
  return with_area == with_samples && areas_connected(grid, area_of_neuron);
}

bool individuals_apart(const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& classes) {
  std::map<std::size_t, std::size_t> class_of_winner;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    const auto [found, is_new] = class_of_winner.emplace(winners[i], classes[i]);
    if (!is_new && found->second != classes[i]) return false;
  }
  return true;
}

}  // namespace somato
