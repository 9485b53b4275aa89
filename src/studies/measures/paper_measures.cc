#include "studies/measures/paper_measures.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "maps/reading/winner_measures.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using SizeGroups = std::map<std::size_t, std::vector<MappedIndividual>>;

// Only differences in the order of places count, so that rounding must not make any.
double rounded_place(double place) {
  constexpr double kSteps = 1e9;  // The places of a group have length 1 at most.
  return std::round(place * kSteps) / kSteps;
}

OrderedGroup along_its_longest(const std::vector<MappedIndividual>& members) {
  OrderedGroup group;
  Matrix<double> products(members.size(), members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    group.numbers.push_back(members[i].number);
    for (std::size_t j = 0; j < members.size(); ++j) {
      const Position& a = members[i].position;
      const Position& b = members[j].position;
      products(i, j) = a.x * b.x + a.y * b.y;
    }
  }
  for (const double place : principal_positions(products)) {
    group.positions.push_back(rounded_place(place));
  }
  return group;
}

bool has_three_numbers(const std::vector<MappedIndividual>& members) {
  std::set<double> different;
  for (const MappedIndividual& member : members) different.insert(member.number);
  return different.size() >= 3;
}

// Adds the sample, scaled to length 1, to a sum with all elements.
void add_direction(const SignalView& sample, std::vector<double>& sum) {
  const double length = std::sqrt(inner_product(sample, sample));
  if (!(length > 0.0)) return;
  for (std::size_t i = 0; i < sample.values.size(); ++i) {
    sum[sample.sparse ? sample.indices[i] : i] += sample.values[i] / length;
  }
}

double summed_squares(const std::vector<double>& vector) {
  double sum = 0.0;
  for (const double value : vector) sum += value * value;
  return sum;
}

}  // namespace

std::size_t samples_sharing_within_class(const std::vector<std::size_t>& winners,
                                         const std::vector<std::size_t>& classes) {
  require(winners.size() == classes.size(), "shared winners need one class per winner");
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> samples_at;  // neuron and class
  for (std::size_t i = 0; i < winners.size(); ++i) ++samples_at[{winners[i], classes[i]}];
  std::size_t sharing = 0;
  for (const auto& [neuron_and_class, samples] : samples_at) {
    if (samples > 1) sharing += samples;
  }
  return sharing;
}

std::size_t samples_with_size_in_other_group(const Grid& grid,
                                             const std::vector<std::size_t>& winners,
                                             const std::vector<std::size_t>& individuals,
                                             const std::vector<SizedThing>& things) {
  for (const std::size_t individual : individuals) {
    require(individual < things.size(), "an individual has no size");
  }
  const std::vector<std::size_t> surroundings = classes_of_surroundings(grid, winners, individuals);
  const std::vector<bool> large = is_large(things);
  std::size_t count = 0;
  for (std::size_t i = 0; i < individuals.size(); ++i) {
    const std::size_t own = individuals[i];
    const std::size_t other = surroundings[i];
    const bool in_other_group = things[own].group != things[other].group;
    count += in_other_group && large[own] == large[other] ? 1 : 0;
  }
  return count;
}

RankOrder order_along(const std::vector<MappedIndividual>& individuals, std::size_t shuffles,
                      std::uint64_t seed) {
  SizeGroups members;
  for (const MappedIndividual& one : individuals) members[one.group].push_back(one);
  std::vector<OrderedGroup> groups;
  for (const auto& [name, group] : members) {
    if (has_three_numbers(group)) groups.push_back(along_its_longest(group));
  }
  return groups.empty() ? RankOrder{} : rank_order(groups, shuffles, seed);
}

// The directions' inner products over all pairs are in the squared length of their sum; those
// within a class in that of the class's sum, as is each direction with itself.
double cosine_between_classes(const Samples& samples, const std::vector<std::size_t>& classes) {
  require(classes.size() <= samples.count(), "one sample for each class is required");
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < classes.size(); ++i) members[classes[i]].push_back(i);
  require(members.size() > 1, "a cosine between classes needs two classes");
  std::vector<double> all(samples.size(), 0.0);
  double within = 0.0;
  auto pairs = static_cast<double>(classes.size() * classes.size());
  for (const auto& [its_class, its_samples] : members) {
    std::vector<double> sum(samples.size(), 0.0);
    for (const std::size_t sample : its_samples) add_direction(samples[sample], sum);
    for (std::size_t i = 0; i < sum.size(); ++i) all[i] += sum[i];
    within += summed_squares(sum);
    pairs -= static_cast<double>(its_samples.size() * its_samples.size());
  }
  return (summed_squares(all) - within) / pairs;
}

}  // namespace somato
