#include "somato/studies/size_groups.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "somato/core/check.h"

namespace somato {
namespace {

double number_of_median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

}  // namespace

std::vector<std::size_t> size_groups(const std::vector<NumberedIndividual>& individuals) {
  std::map<std::size_t, std::vector<double>> numbers;
  for (const NumberedIndividual& individual : individuals) {
    require(std::isfinite(individual.number), "individuals need finite numbers");
    numbers[individual.group].push_back(individual.number);
  }
  std::map<std::size_t, double> medians;
  for (const auto& [group, its_numbers] : numbers) medians[group] = number_of_median(its_numbers);
  std::vector<std::size_t> classes;
  classes.reserve(individuals.size());
  for (const NumberedIndividual& individual : individuals) {
    const bool large = individual.number >= medians[individual.group];
    classes.push_back(2 * individual.group + (large ? 1 : 0));
  }
  return classes;
}

}  // namespace somato
