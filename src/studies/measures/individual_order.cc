#include "studies/measures/individual_order.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/core/rank_correlation.h"
#include "studies/measures/numbered_individuals.h"
#include "studies/measures/rank_order.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// The inner product of the individuals' mean vectors.
double mean_inner_product(const Samples& vectors, const NumberedIndividual& a,
                          const NumberedIndividual& b) {
  double sum = 0.0;
  for (const std::size_t i : a.samples) {
    for (const std::size_t j : b.samples) sum += inner_product(vectors[i], vectors[j]);
  }
  return sum / static_cast<double>(a.samples.size() * b.samples.size());
}

OrderedGroup ordered(const std::vector<NumberedIndividual>& members, const Samples& vectors) {
  Matrix<double> products(members.size(), members.size());
  OrderedGroup group;
  for (std::size_t i = 0; i < members.size(); ++i) {
    group.numbers.push_back(members[i].number);
    for (std::size_t j = 0; j <= i; ++j) {
      products(i, j) = mean_inner_product(vectors, members[i], members[j]);
      products(j, i) = products(i, j);
    }
  }
  group.positions = principal_positions(products);
  return group;
}

}  // namespace

Result<OrderInformation> order_of_individuals(const Recording& recording,
                                              const InformationParameters& parameters,
                                              const Numbers& individuals, const Samples& vectors) {
  auto all = numbered_individuals(
      recording, {parameters.individual, parameters.order, parameters.within}, individuals);
  if (!all) return fail(std::move(all.error()));
  std::map<std::string, std::vector<NumberedIndividual>> members;
  for (NumberedIndividual& individual : *all)
    members[individual.group].push_back(std::move(individual));
  OrderInformation information;
  std::vector<OrderedGroup> groups;
  for (const auto& [name, group] : members) {
    if (!has_an_order(group)) continue;
    groups.push_back(ordered(group, vectors));
    const double correlation = rank_correlation(groups.back().numbers, groups.back().positions);
    information.groups.push_back({name, group.size(), std::abs(correlation)});
  }
  if (groups.empty()) {
    return fail(no_order(parameters.order));
  }
  const RankOrder order = rank_order(groups, parameters.shuffles, parameters.seed);
  information.correlation = order.correlation;
  information.shuffled = order.shuffled;
  information.shuffled_share = order.shuffled_share;
  return information;
}

}  // namespace somato
