#include "maps/grid/size_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/core/rank_correlation.h"
#include "maps/grid/ring.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Sizes = std::vector<double>;

constexpr double kEqualCorrelations = 1e-12;  // what counts as equal correlations after rounding

constexpr std::size_t kFewestInOrder = 3;  // Two numbers are always in order.

std::vector<Position> from_their_centre(const std::vector<MappedIndividual>& individuals) {
  Position centre;
  for (const MappedIndividual& individual : individuals) {
    centre.x += individual.position.x;
    centre.y += individual.position.y;
  }
  const auto count = static_cast<double>(individuals.size());
  std::vector<Position> found;
  found.reserve(individuals.size());
  for (const MappedIndividual& individual : individuals) {
    found.push_back(
        {individual.position.x - centre.x / count, individual.position.y - centre.y / count});
  }
  return found;
}

// Some of the individuals: their ring, and the ranks of their numbers.
struct Ranked {
  Ring ring;
  Sizes ranks;
};

double best_of_both(const RingOrder& order) {
  return std::max(order.growing, order.falling);
}

double order_around(const Ranked& all) {
  return best_of_both(all.ring.best_order(all.ranks));
}

double order_within(const std::vector<Ranked>& groups) {
  if (groups.empty()) return 0.0;
  RingOrder sum;
  for (const Ranked& group : groups) {
    const RingOrder order = group.ring.best_order(group.ranks);
    sum.growing += order.growing;
    sum.falling += order.falling;
  }
  return best_of_both(sum) / static_cast<double>(groups.size());
}

std::size_t fewest_of_both(const RingExceptions& exceptions) {
  return std::min(exceptions.growing, exceptions.falling);
}

std::size_t exceptions_within(const std::vector<Ranked>& groups) {
  RingExceptions sum;
  for (const Ranked& group : groups) {
    const RingExceptions exceptions = group.ring.least_exceptions(group.ranks);
    sum.growing += exceptions.growing;
    sum.falling += exceptions.falling;
  }
  return fewest_of_both(sum);
}

// The data from which the orders are computed.
struct Rankings {
  Ranked all;
  std::vector<Ranked> groups;
};

void require_finite(const std::vector<MappedIndividual>& individuals) {
  require(!individuals.empty(), "an order needs individuals");
  for (const MappedIndividual& individual : individuals) {
    const bool finite = std::isfinite(individual.number) && std::isfinite(individual.position.x) &&
                        std::isfinite(individual.position.y);
    require(finite, "an order needs finite numbers and positions");
  }
}

Rankings rankings_of(const std::vector<MappedIndividual>& individuals) {
  require_finite(individuals);
  const std::vector<Position> places = from_their_centre(individuals);
  Sizes all;
  all.reserve(individuals.size());
  std::map<std::size_t, std::pair<std::vector<Position>, Sizes>> members;
  for (std::size_t i = 0; i < individuals.size(); ++i) {
    all.push_back(individuals[i].number);
    auto& [group_places, group_numbers] = members[individuals[i].group];
    group_places.push_back(places[i]);
    group_numbers.push_back(individuals[i].number);
  }
  Rankings rankings{{Ring(places), centred_ranks(all)}, {}};
  rankings.groups.reserve(members.size());
  for (const auto& [group, its] : members) {
    const std::set<double> different(its.second.begin(), its.second.end());
    if (different.size() < kFewestInOrder) continue;
    rankings.groups.push_back({Ring(its.first), centred_ranks(its.second)});
  }
  return rankings;
}

CircularOrder order_of(const Rankings& rankings) {
  return {order_around(rankings.all), order_within(rankings.groups),
          fewest_of_both(rankings.all.ring.least_exceptions(rankings.all.ranks)),
          exceptions_within(rankings.groups)};
}

// Equal numbers have equal ranks: to shuffle the ranks is to shuffle the numbers.
void shuffle(Rankings& rankings, Random& random) {
  shuffle(rankings.all.ranks, random);
  for (Ranked& group : rankings.groups) shuffle(group.ranks, random);
}

}  // namespace

std::vector<MappedIndividual> mapped_individuals(const Grid& grid,
                                                 const std::vector<std::size_t>& winners,
                                                 const std::vector<std::size_t>& individuals,
                                                 const std::vector<double>& numbers,
                                                 const std::vector<std::size_t>& groups) {
  require(winners.size() == individuals.size(),
          "a map of individuals needs one individual per winner");
  require(numbers.size() == groups.size(), "each individual needs a number and a group");
  std::vector<MappedIndividual> mapped(numbers.size());
  std::vector<double> samples(numbers.size(), 0.0);
  for (std::size_t i = 0; i < winners.size(); ++i) {
    require(winners[i] < grid.size(), "a winner is not on the map");
    require(individuals[i] < mapped.size(), "an individual has no number");
    const Position at = grid.position(winners[i]);
    mapped[individuals[i]].position.x += at.x;
    mapped[individuals[i]].position.y += at.y;
    samples[individuals[i]] += 1.0;
  }
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    require(samples[i] > 0.0, "an individual has no sample");
    const Position& sum = mapped[i].position;
    mapped[i] = {numbers[i], groups[i], {sum.x / samples[i], sum.y / samples[i]}};
  }
  return mapped;
}

CircularOrder circular_order(const std::vector<MappedIndividual>& individuals) {
  return order_of(rankings_of(individuals));
}

CircularOrderByChance circular_order_chance(const std::vector<MappedIndividual>& individuals,
                                            std::size_t shuffles, std::uint64_t seed) {
  Rankings rankings = rankings_of(individuals);
  const CircularOrder right = order_of(rankings);
  Random random(seed, Stream::kSizeOrder);
  OrderFigures sum;
  OrderFigures as_high{1.0, 1.0};  // the true order is one of them
  std::vector<CircularOrder> of_each;
  of_each.reserve(shuffles);
  for (std::size_t i = 0; i < shuffles; ++i) {
    shuffle(rankings, random);
    const CircularOrder order = order_of(rankings);
    of_each.push_back(order);
    sum.around += order.around;
    sum.within += order.within;
    as_high.around += order.around >= right.around - kEqualCorrelations ? 1.0 : 0.0;
    as_high.within += order.within >= right.within - kEqualCorrelations ? 1.0 : 0.0;
  }
  const double many = std::max(static_cast<double>(shuffles), 1.0);
  const double all = static_cast<double>(shuffles) + 1.0;
  return {{sum.around / many, sum.within / many},
          {as_high.around / all, as_high.within / all},
          std::move(of_each)};
}

}  // namespace somato
