#include "maps/grid/areas.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "somato/core/check.h"

namespace somato {
namespace {

// The samples whose winner is nearest to `neuron`.
std::vector<std::size_t> nearest_samples(const Grid& grid, std::size_t neuron,
                                         const std::vector<std::size_t>& winners) {
  constexpr double kTolerance = 1e-9;  // equal distances on a hexagonal grid differ by rounding
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    const double distance = grid.squared_distance(neuron, winners[i]);
    if (distance > least + kTolerance) continue;
    if (distance < least - kTolerance) {
      nearest.clear();
      least = distance;
    }
    nearest.push_back(i);
  }
  return nearest;
}

}  // namespace

WinnerAreas::WinnerAreas(const Grid& grid, const std::vector<std::size_t>& winners)
    : samples_(winners.size()) {
  require(!winners.empty(), "areas need at least one winner");
  for (const std::size_t winner : winners) {
    require(winner < grid.size(), "a winner is not on the map");
  }
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    nearest_samples_.push_back(nearest_samples(grid, neuron, winners));
    neighbours_.push_back(grid.neighbours(neuron));
  }
}

std::vector<std::size_t> WinnerAreas::classes_of_neurons(
    const std::vector<std::size_t>& classes) const {
  require(classes.size() == samples_, "areas need a class for each winner");
  std::vector<std::size_t> class_of_neuron;
  for (const std::vector<std::size_t>& samples : nearest_samples_) {
    std::map<std::size_t, std::size_t> votes;  // class -> samples, ascending
    for (const std::size_t sample : samples) ++votes[classes[sample]];
    const auto most =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    class_of_neuron.push_back(most->first);
  }
  return class_of_neuron;
}

bool WinnerAreas::connected(const std::vector<std::size_t>& classes) const {
  const std::vector<std::size_t> class_of_neuron = classes_of_neurons(classes);
  const std::set<std::size_t> with_area(class_of_neuron.begin(), class_of_neuron.end());
  const std::set<std::size_t> with_samples(classes.begin(), classes.end());
  return with_area == with_samples && regions_connected(class_of_neuron);
}

bool WinnerAreas::regions_connected(const std::vector<std::size_t>& class_of_neuron) const {
  std::vector<bool> visited(class_of_neuron.size());
  std::set<std::size_t> seen;
  for (std::size_t start = 0; start < class_of_neuron.size(); ++start) {
    if (visited[start]) continue;
    if (!seen.insert(class_of_neuron[start]).second) return false;
    std::vector<std::size_t> to_visit{start};
    visited[start] = true;
    while (!to_visit.empty()) {
      const std::size_t neuron = to_visit.back();
      to_visit.pop_back();
      for (const std::size_t other : neighbours_[neuron]) {
        if (visited[other] || class_of_neuron[other] != class_of_neuron[start]) continue;
        visited[other] = true;
        to_visit.push_back(other);
      }
    }
  }
  return true;
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
