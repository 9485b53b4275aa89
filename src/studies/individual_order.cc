#include "studies/individual_order.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "somato/core/rank_correlation.h"
#include "studies/exploration_samples.h"
#include "studies/rank_order.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

constexpr std::size_t kFewestInOrder = 3;  // Two numbers are always in order.

Result<double> number_from(const std::string& text, const std::string& label) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && rest == end && std::isfinite(number)) return number;
  return fail(ErrorKind::kData, fmt::format("the label '{}' says '{}', no number", label, text), {},
              "name a label of numbers as 'order'");
}

// An individual as the order sees it.
struct Individual {
  std::string group;
  double number = 0.0;
  Numbers samples;
};

Error differs(const std::string& individual, const std::string& label) {
  return {ErrorKind::kData,
          fmt::format("explorations with the same '{}' differ in '{}'", individual, label),
          {},
          "name another label as 'individual'"};
}

Result<std::vector<Individual>> individuals_in_order(const Recording& recording,
                                                     const InformationParameters& asked,
                                                     const Numbers& individuals) {
  const auto texts = labels_of(recording, asked.order);
  if (!texts) return fail(texts.error());
  auto groups = std::vector<std::string>(texts->size());
  if (!asked.within.empty()) {
    auto found = labels_of(recording, asked.within);
    if (!found) return fail(std::move(found.error()));
    groups = std::move(*found);
  }
  std::map<std::size_t, Individual> found;
  for (std::size_t sample = 0; sample < texts->size(); ++sample) {
    const auto number = number_from((*texts)[sample], asked.order);
    if (!number) return fail(number.error());
    const Individual first{groups[sample], *number, {}};
    Individual& individual = found.emplace(individuals[sample], first).first->second;
    if (individual.number != *number) return fail(differs(asked.individual, asked.order));
    if (individual.group != groups[sample]) return fail(differs(asked.individual, asked.within));
    individual.samples.push_back(sample);
  }
  std::vector<Individual> all;
  all.reserve(found.size());
  for (auto& [number, individual] : found) all.push_back(std::move(individual));
  return all;
}

// The inner product of the individuals' mean vectors.
double mean_inner_product(const Samples& vectors, const Individual& a, const Individual& b) {
  double sum = 0.0;
  for (const std::size_t i : a.samples) {
    for (const std::size_t j : b.samples) sum += inner_product(vectors[i], vectors[j]);
  }
  return sum / static_cast<double>(a.samples.size() * b.samples.size());
}

OrderedGroup ordered(const std::vector<Individual>& members, const Samples& vectors) {
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

bool has_an_order(const std::vector<Individual>& members) {
  std::set<double> numbers;
  for (const Individual& member : members) numbers.insert(member.number);
  return numbers.size() >= kFewestInOrder;
}

}  // namespace

Result<OrderInformation> order_of_individuals(const Recording& recording,
                                              const InformationParameters& asked,
                                              const Numbers& individuals, const Samples& vectors) {
  auto all = individuals_in_order(recording, asked, individuals);
  if (!all) return fail(std::move(all.error()));
  std::map<std::string, std::vector<Individual>> members;
  for (Individual& individual : *all) members[individual.group].push_back(std::move(individual));
  OrderInformation information;
  std::vector<OrderedGroup> groups;
  for (const auto& [name, group] : members) {
    if (!has_an_order(group)) continue;
    groups.push_back(ordered(group, vectors));
    const double correlation = rank_correlation(groups.back().numbers, groups.back().positions);
    information.groups.push_back({name, group.size(), std::abs(correlation)});
  }
  if (groups.empty()) {
    return fail(
        ErrorKind::kData,
        fmt::format("no group has {} individuals of different '{}'", kFewestInOrder, asked.order),
        {}, "two numbers are always in order; name another label as 'order' or 'within'");
  }
  const RankOrder order = rank_order(groups, asked.shuffles, asked.seed);
  information.correlation = order.correlation;
  information.shuffled = order.shuffled;
  information.shuffled_share = order.shuffled_share;
  return information;
}

}  // namespace somato
