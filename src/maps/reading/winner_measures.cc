#include "maps/reading/winner_measures.h"

#include <algorithm>
#include <limits>
#include <map>

#include "somato/core/check.h"

namespace somato {
namespace {

void require_samples(const std::vector<std::size_t>& winners,
                     const std::vector<std::size_t>& classes) {
  require(winners.size() == classes.size(), "measures of winners need one class per winner");
  require(!winners.empty(), "measures of winners need at least one sample");
}

void require_on(const Grid& grid, const std::vector<std::size_t>& winners) {
  require(!winners.empty(), "measures of winners need at least one sample");
  const auto is_on = [&](std::size_t winner) { return winner < grid.size(); };
  require(std::all_of(winners.begin(), winners.end(), is_on), "a winner is not on the map");
}

// For each sample, whether its neuron is shared with a sample of another class.
std::vector<bool> shares_with_another(const std::vector<std::size_t>& winners,
                                      const std::vector<std::size_t>& classes) {
  std::map<std::size_t, std::size_t> first_class;  // neuron -> class
  std::map<std::size_t, bool> is_shared;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    const std::size_t first = first_class.emplace(winners[i], classes[i]).first->second;
    if (first != classes[i]) is_shared[winners[i]] = true;
  }
  std::vector<bool> shares;
  shares.reserve(winners.size());
  for (const std::size_t winner : winners) shares.push_back(is_shared.contains(winner));
  return shares;
}

// The other samples whose winners are nearest to that of `sample`, counted by class; itself when
// there is no other.
std::map<std::size_t, std::size_t> votes_around(const Grid& grid, std::size_t sample,
                                                const std::vector<std::size_t>& winners,
                                                const std::vector<std::size_t>& classes) {
  constexpr double kEqualDistances =
      1e-9;  // equal distances on a hexagonal grid differ by rounding
  std::vector<double> distances;
  distances.reserve(winners.size());
  for (const std::size_t winner : winners) {
    distances.push_back(grid.squared_distance(winners[sample], winner));
  }
  distances[sample] = std::numeric_limits<double>::infinity();
  const double nearest = *std::min_element(distances.begin(), distances.end()) + kEqualDistances;
  std::map<std::size_t, std::size_t> votes;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (distances[i] <= nearest) ++votes[classes[i]];
  }
  return votes;
}

std::size_t elected(const std::map<std::size_t, std::size_t>& votes, std::size_t own) {
  std::size_t best = own;
  std::size_t most = votes.contains(own) ? votes.at(own) : 0;
  for (const auto& [its_class, count] : votes) {
    if (count <= most) continue;
    best = its_class;
    most = count;
  }
  return best;
}

bool on_border(const Grid& grid, std::size_t neuron) {
  const std::size_t row = grid.row_of(neuron);
  const std::size_t column = grid.column_of(neuron);
  return row == 0 || row + 1 == grid.rows() || column == 0 || column + 1 == grid.columns();
}

}  // namespace

std::vector<bool> separated_classes(const std::vector<std::size_t>& winners,
                                    const std::vector<std::size_t>& classes) {
  require_samples(winners, classes);
  std::vector<bool> separated(*std::max_element(classes.begin(), classes.end()) + 1, false);
  for (const std::size_t its_class : classes) separated[its_class] = true;
  const std::vector<bool> shares = shares_with_another(winners, classes);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (shares[i]) separated[classes[i]] = false;
  }
  return separated;
}

std::size_t ambiguous_samples(const std::vector<std::size_t>& winners,
                              const std::vector<std::size_t>& classes) {
  require_samples(winners, classes);
  const std::vector<bool> shares = shares_with_another(winners, classes);
  return static_cast<std::size_t>(std::count(shares.begin(), shares.end(), true));
}

std::vector<std::size_t> classes_of_surroundings(const Grid& grid,
                                                 const std::vector<std::size_t>& winners,
                                                 const std::vector<std::size_t>& classes) {
  require_samples(winners, classes);
  require_on(grid, winners);
  std::vector<std::size_t> around;
  around.reserve(winners.size());
  for (std::size_t i = 0; i < winners.size(); ++i) {
    around.push_back(elected(votes_around(grid, i, winners, classes), classes[i]));
  }
  return around;
}

double share_on_border(const Grid& grid, const std::vector<std::size_t>& winners) {
  require_on(grid, winners);
  const auto is_there = [&](std::size_t winner) { return on_border(grid, winner); };
  const auto there = std::count_if(winners.begin(), winners.end(), is_there);
  return static_cast<double>(there) / static_cast<double>(winners.size());
}

double border_of(const Grid& grid) {
  require(grid.size() > 0, "a map without neurons has no border");
  const std::size_t inner_rows = grid.rows() > 2 ? grid.rows() - 2 : 0;
  const std::size_t inner_columns = grid.columns() > 2 ? grid.columns() - 2 : 0;
  const auto there = static_cast<double>(grid.size() - inner_rows * inner_columns);
  return there / static_cast<double>(grid.size());
}

}  // namespace somato
