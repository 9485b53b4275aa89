#include "studies/measures/numbered_individuals.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/text/number_of_text.h"
#include "studies/description/exploration_samples.h"

namespace somato {
namespace {

constexpr std::size_t kFewestInOrder = 3;

Result<double> number_from(const std::string& text, const std::string& label) {
  const auto number = number_of_text<double>(text);
  if (number && std::isfinite(*number)) return *number;
  return fail(ErrorKind::kData,
              fmt::format("the label '{}' is '{}', which is not a number", label, text), {},
              "use a label with numbers as 'order'");
}

Error differs(const std::string& individual, const std::string& label) {
  return {ErrorKind::kData,
          fmt::format("explorations with the same '{}' differ in '{}'", individual, label),
          {},
          "use another label as 'individual'"};
}

}  // namespace

Result<std::vector<NumberedIndividual>> numbered_individuals(
    const Recording& recording, const NumberedLabels& labels,
    const std::vector<std::size_t>& individuals) {
  SOMATO_TRY(const auto texts, labels_of(recording, labels.order));
  auto groups = std::vector<std::string>(texts.size());
  if (!labels.within.empty()) {
    SOMATO_TRY(auto found, labels_of(recording, labels.within));
    groups = std::move(found);
  }
  std::map<std::size_t, NumberedIndividual> found;
  for (std::size_t sample = 0; sample < texts.size(); ++sample) {
    SOMATO_TRY(const auto number, number_from(texts[sample], labels.order));
    const NumberedIndividual first{groups[sample], number, {}};
    NumberedIndividual& individual = found.emplace(individuals[sample], first).first->second;
    if (individual.number != number) return fail(differs(labels.individual, labels.order));
    if (individual.group != groups[sample]) return fail(differs(labels.individual, labels.within));
    individual.samples.push_back(sample);
  }
  std::vector<NumberedIndividual> all;
  all.reserve(found.size());
  for (auto& [number, individual] : found) all.push_back(std::move(individual));
  return all;
}

bool has_an_order(const std::vector<NumberedIndividual>& members) {
  std::set<double> numbers;
  for (const NumberedIndividual& member : members) numbers.insert(member.number);
  return numbers.size() >= kFewestInOrder;
}

Error no_order(const std::string& order) {
  return {ErrorKind::kData,
          fmt::format("no group has {} individuals of different '{}'", kFewestInOrder, order),
          {},
          "two numbers are always in order; use another label as 'order' or 'within'"};
}

}  // namespace somato
