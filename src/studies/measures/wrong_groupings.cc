#include "studies/measures/wrong_groupings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// The class of each individual, which all its samples must have.
std::vector<std::size_t> class_of_individuals(const std::vector<std::size_t>& classes,
                                              const std::vector<std::size_t>& individuals) {
  std::map<std::size_t, std::size_t> class_of;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto [found, is_new] = class_of.emplace(individuals[i], classes[i]);
    require(found->second == classes[i], "all samples of an individual must have one class");
  }
  std::vector<std::size_t> dealt;
  dealt.reserve(class_of.size());
  for (const auto& [individual, its_class] : class_of) dealt.push_back(its_class);
  return dealt;
}

// Independent of the numbering of the classes: classes are numbered by their first individual.
std::vector<std::size_t> partition(const std::vector<std::size_t>& dealt) {
  std::map<std::size_t, std::size_t> number;
  std::vector<std::size_t> canonical;
  canonical.reserve(dealt.size());
  for (const std::size_t its_class : dealt) {
    canonical.push_back(number.emplace(its_class, number.size()).first->second);
  }
  return canonical;
}

// With one class, or one individual a class, every dealing puts the same individuals together.
bool only_one_partition(const std::vector<std::size_t>& dealt) {
  const std::set<std::size_t> classes(dealt.begin(), dealt.end());
  return classes.size() <= 1 || classes.size() == dealt.size();
}

}  // namespace

std::vector<std::vector<std::size_t>> wrong_groupings(const std::vector<std::size_t>& classes,
                                                      const std::vector<std::size_t>& individuals,
                                                      std::size_t count, std::uint64_t seed) {
  require(classes.size() == individuals.size(), "wrong groupings need one individual per sample");
  std::vector<std::size_t> dealt = class_of_individuals(classes, individuals);
  if (only_one_partition(dealt)) return {};
  const std::vector<std::size_t> right = partition(dealt);
  std::map<std::size_t, std::size_t> place_of_individual;
  for (const std::size_t individual : individuals) place_of_individual.emplace(individual, 0);
  std::size_t place = 0;
  for (auto& [individual, its_place] : place_of_individual) its_place = place++;

  Random random(seed, Stream::kGroupings);
  std::vector<std::vector<std::size_t>> groupings;
  while (groupings.size() < count) {
    shuffle(dealt, random);
    if (partition(dealt) == right) continue;
    std::vector<std::size_t> grouping;
    grouping.reserve(individuals.size());
    for (const std::size_t individual : individuals) {
      grouping.push_back(dealt[place_of_individual[individual]]);
    }
    groupings.push_back(std::move(grouping));
  }
  return groupings;
}

}  // namespace somato
