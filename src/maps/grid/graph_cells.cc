#include "maps/grid/graph_cells.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Place = std::pair<std::int64_t, std::int64_t>;  // row and column, from the first neuron

// The sum of places, and their number.
struct Sum {
  Place places{0, 0};
  std::int64_t count = 0;

  // The squared distance of a place from the mean, times count^2: integers, without rounding.
  std::int64_t distance(Place place) const {
    const std::int64_t row = count * place.first - places.first;
    const std::int64_t column = count * place.second - places.second;
    return row * row + column * column;
  }
};

// Places the neurons of one connected part.
class PartLayout {
 public:
  PartLayout(const std::vector<Numbers>& neighbours, std::map<std::size_t, Place>& places)
      : neighbours_(neighbours), places_(places) {}

  // Next is the neuron with the most placed neighbours; in a tie, that with the most neighbours.
  void place_all(Numbers neurons) {
    while (!neurons.empty()) {
      const auto next =
          std::max_element(neurons.begin(), neurons.end(), [&](std::size_t a, std::size_t b) {
            return std::pair(placed_around(a).count, neighbours_[a].size()) <
                   std::pair(placed_around(b).count, neighbours_[b].size());
          });
      take(free_near(placed_around(*next)), *next);
      neurons.erase(next);
    }
  }

 private:
  Sum placed_around(std::size_t neuron) const {
    Sum sum;
    for (const std::size_t other : neighbours_[neuron]) {
      const auto place = places_.find(other);
      if (place == places_.end()) continue;
      sum.places.first += place->second.first;
      sum.places.second += place->second.second;
      ++sum.count;
    }
    return sum;
  }

  Place free_near(const Sum& sum) const {
    return *std::min_element(free_.begin(), free_.end(), [&](const Place& a, const Place& b) {
      return sum.distance(a) < sum.distance(b);
    });
  }

  // The places around it become free ones to choose from.
  void take(Place place, std::size_t neuron) {
    places_[neuron] = place;
    taken_.insert(place);
    free_.erase(place);
    for (const std::int64_t row : {-1, 0, 1}) {
      for (const std::int64_t column : {-1, 0, 1}) {
        const Place beside{place.first + row, place.second + column};
        if (!taken_.contains(beside)) free_.insert(beside);
      }
    }
  }

  const std::vector<Numbers>& neighbours_;
  std::map<std::size_t, Place>& places_;
  std::set<Place> taken_;
  std::set<Place> free_{{0, 0}};
};

// The neurons of each part.
std::vector<Numbers> members_of(const Numbers& parts) {
  std::vector<Numbers> members;
  for (std::size_t neuron = 0; neuron < parts.size(); ++neuron) {
    if (parts[neuron] >= members.size()) members.resize(parts[neuron] + 1);
    members[parts[neuron]].push_back(neuron);
  }
  return members;
}

}  // namespace

std::vector<NeuronGraph::Cell> cells_of_graph(const std::vector<Numbers>& neighbours,
                                              const Numbers& parts) {
  std::vector<NeuronGraph::Cell> cells(parts.size());
  std::size_t left = 0;
  for (const Numbers& neurons : members_of(parts)) {
    std::map<std::size_t, Place> places;
    PartLayout(neighbours, places).place_all(neurons);
    Place first{0, 0};
    std::int64_t last = 0;
    for (const auto& [neuron, place] : places) {
      first = {std::min(first.first, place.first), std::min(first.second, place.second)};
      last = std::max(last, place.second);
    }
    for (const auto& [neuron, place] : places) {
      cells[neuron] = {static_cast<std::size_t>(place.first - first.first),
                       left + static_cast<std::size_t>(place.second - first.second)};
    }
    left += static_cast<std::size_t>(last - first.second) + 2;
  }
  return cells;
}

}  // namespace somato
