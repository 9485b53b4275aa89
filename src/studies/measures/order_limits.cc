#include "studies/measures/paper_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/core/rank_correlation.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using Ranks = std::vector<double>;

constexpr std::size_t kMostGroups = 5;  // 120 orders of the groups

// Ascending ranks of the numbers of each group.
using RanksOfGroups = std::vector<Ranks>;

RanksOfGroups ranks_of_groups(const Ranks& ranks, const std::vector<std::size_t>& groups) {
  std::map<std::size_t, Ranks> members;
  for (std::size_t i = 0; i < ranks.size(); ++i) members[groups[i]].push_back(ranks[i]);
  RanksOfGroups sorted;
  for (auto& [group, its] : members) {
    std::sort(its.begin(), its.end());
    sorted.push_back(std::move(its));
  }
  return sorted;
}

std::size_t different(const Ranks& numbers) {
  return std::set<double>(numbers.begin(), numbers.end()).size();
}

// Areas around the map, beginning with one that the start divides: the rest of it is at the end.
Ranks followed_by(const RanksOfGroups& areas, std::size_t before) {
  const Ranks& divided = areas.front();
  const auto middle = divided.begin() + static_cast<std::ptrdiff_t>(before);
  Ranks around(divided.begin(), middle);
  for (std::size_t i = 1; i < areas.size(); ++i) {
    around.insert(around.end(), areas[i].begin(), areas[i].end());
  }
  around.insert(around.end(), middle, divided.end());
  return around;
}

Ranks counted_from_one(std::size_t count) {
  Ranks places;
  for (std::size_t i = 0; i < count; ++i) places.push_back(static_cast<double>(i + 1));
  return places;
}

// Within its places each area is best with ascending numbers (the rearrangement inequality).
double greatest_around(const RanksOfGroups& areas, const Ranks& places) {
  double greatest = -1.0;
  for (std::size_t before = 0; before <= areas.front().size(); ++before) {
    greatest = std::max(greatest, rank_correlation(followed_by(areas, before), places));
  }
  return greatest;
}

std::size_t between(const Ranks& sorted, double low, double high) {
  return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), high) -
                                  std::lower_bound(sorted.begin(), sorted.end(), low));
}

// The most individuals in order if those of the divided area up to `first` are before the others:
// for each number, the most up to an area whose greatest kept number it is.
std::size_t most_in_order(const RanksOfGroups& areas, const Ranks& numbers, double first) {
  const Ranks& divided = areas.front();
  std::map<double, std::size_t> most{{first, between(divided, numbers.front(), first)}};
  for (std::size_t area = 1; area < areas.size(); ++area) {
    std::map<double, std::size_t> next = most;
    for (const auto& [reached, count] : most) {
      for (const double to : numbers) {
        if (to < reached) continue;
        std::size_t& kept = next[to];
        kept = std::max(kept, count + between(areas[area], reached, to));
      }
    }
    most = std::move(next);
  }
  std::size_t greatest = 0;
  for (const auto& [reached, count] : most) {
    // Without others in between, a greater `first` counts the rest.
    const std::size_t after = reached > first ? between(divided, reached, numbers.back()) : 0;
    greatest = std::max(greatest, count + after);
  }
  return greatest;
}

std::size_t most_in_order(const RanksOfGroups& areas, const Ranks& numbers) {
  const double none = numbers.front() - 1.0;
  std::size_t most = most_in_order(areas, numbers, none);
  for (const double first : numbers) most = std::max(most, most_in_order(areas, numbers, first));
  return most;
}

double greatest_within(const RanksOfGroups& areas) {
  constexpr std::size_t kFewestNumbers = 3;
  double sum = 0.0;
  double count = 0.0;
  for (const Ranks& area : areas) {
    if (different(area) < kFewestNumbers) continue;
    sum += rank_correlation(area, counted_from_one(area.size()));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

std::optional<OrderLimits> order_limits(const std::vector<double>& numbers,
                                        const std::vector<std::size_t>& groups) {
  require(!numbers.empty() && numbers.size() == groups.size(),
          "limits of an order need individuals with a group each");
  require(
      std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); }),
      "limits of an order need finite numbers");
  RanksOfGroups areas = ranks_of_groups(ranks_of(numbers), groups);
  if (areas.size() > kMostGroups || different(numbers) < 2) return {};
  std::set<double> sorted;
  for (const Ranks& area : areas) sorted.insert(area.begin(), area.end());
  const Ranks all(sorted.begin(), sorted.end());
  const Ranks places = counted_from_one(numbers.size());
  OrderLimits limits{-1.0, greatest_within(areas), numbers.size()};
  std::sort(areas.begin(), areas.end());
  do {
    limits.around = std::max(limits.around, greatest_around(areas, places));
    limits.exceptions_around =
        std::min(limits.exceptions_around, numbers.size() - most_in_order(areas, all));
  } while (std::next_permutation(areas.begin(), areas.end()));
  return limits;
}

}  // namespace somato
